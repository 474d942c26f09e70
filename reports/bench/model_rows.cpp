#include "reports/bench/model_rows.h"

#include <algorithm>
#include <random>

#include "spec/exact.h"
#include "spec/filter.h"
#include "spec/gradient.h"

namespace selvage::reports {

namespace {

struct Bounds {
  int32_t left_px, top_px, right_px, bottom_px;  // half-open, wide enough for every covered pixel
};

Bounds bounds_of(const std::vector<selvage_vertex>& polygon, int32_t side_px) {
  const auto [left, right] = std::minmax_element(
      polygon.begin(), polygon.end(), [](const auto& a, const auto& b) { return a.x < b.x; });
  const auto [top, bottom] = std::minmax_element(
      polygon.begin(), polygon.end(), [](const auto& a, const auto& b) { return a.y < b.y; });
  const auto px = [&](int32_t fx8) { return std::clamp(fx8 / SELVAGE_SUBPIXELS, 0, side_px); };
  return {px(left->x), px(top->y), px(right->x + SELVAGE_SUBPIXELS),
          px(bottom->y + SELVAGE_SUBPIXELS)};
}

uint32_t filtered_colour(const spec::Sample& sample, const spec::BoxSides& sides,
                         const Workload& load) {
  const auto taps = [&](const spec::Rational& coordinate, int32_t side_fx8) {
    return spec::addressed(spec::taps(load.filter, coordinate, side_fx8), load.texture_side_texel,
                           SELVAGE_ADDRESS_CLAMP);
  };
  return spec::weighted_mean(taps(sample.u, sides.u_fx8), taps(sample.v, sides.v_fx8),
                             [](const spec::Texel& texel) { return noise_of(texel.s, texel.t); });
}

uint32_t nearest_colour(const spec::Sample& sample, int32_t side_texel) {
  const spec::Texel texel =
      spec::nearest_texel(sample, side_texel, side_texel, SELVAGE_ADDRESS_CLAMP);
  return place_of(texel.s, texel.t);
}

spec::BoxSides sides_of(const Workload& load, const std::vector<selvage_vertex>& polygon, int32_t x,
                        int32_t y) {
  if (load.filter != kArea) return {};
  return spec::box_sides(spec::gradient(polygon, x, y).value());
}

ModelPixel model_pixel(const spec::Sample& sample, const spec::BoxSides& sides,
                       const Workload& load) {
  const int32_t side = load.texture_side_texel;
  const double end = static_cast<double>(side);
  return {load.filter == SELVAGE_FILTER_NEAREST ? nearest_colour(sample, side)
                                                : filtered_colour(sample, sides, load),
          std::clamp(sample.u.get_d(), 0.0, end), std::clamp(sample.v.get_d(), 0.0, end)};
}

}  // namespace

std::vector<int32_t> sample_rows(int32_t height_px, int32_t count, uint64_t seed) {
  count = std::min(count, height_px);
  std::mt19937_64 random(seed);
  std::vector<int32_t> rows;
  for (int32_t i = 0; i < count; ++i) {
    const int32_t begin = static_cast<int32_t>(int64_t{height_px} * i / count);
    const int32_t end = static_cast<int32_t>(int64_t{height_px} * (i + 1) / count);
    rows.push_back(begin + static_cast<int32_t>(random() % static_cast<uint64_t>(end - begin)));
  }
  return rows;
}

ModelRows model_rows(const Workload& load, std::vector<int32_t> rows_px,
                     const std::function<void()>& tick) {
  const int32_t side = load.target_side_px;
  std::vector<Bounds> bounds;
  for (const auto& polygon : load.polygons) bounds.push_back(bounds_of(polygon, side));
  ModelRows model;
  model.rows_px = std::move(rows_px);
  for (const int32_t y : model.rows_px) {
    std::vector<ModelPixel> row(static_cast<size_t>(side));
    for (size_t p = 0; p < bounds.size(); ++p) {
      if (y < bounds[p].top_px || y >= bounds[p].bottom_px) continue;
      const auto line = spec::scan_line(load.polygons[p], y);
      if (!line) continue;
      for (int32_t x = bounds[p].left_px; x < bounds[p].right_px; ++x) {
        const auto sample = spec::sample(*line, x);
        if (!sample) continue;
        row[static_cast<size_t>(x)] =
            model_pixel(*sample, sides_of(load, load.polygons[p], x, y), load);
      }
    }
    model.pixels.push_back(std::move(row));
    tick();
  }
  return model;
}

}  // namespace selvage::reports
