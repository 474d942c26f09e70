#include "reports/bench/error_count.h"

#include <algorithm>
#include <numeric>
#include <random>

#include "spec/exact.h"

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

[[nodiscard]] uint32_t model_pixel(const spec::ScanLine& line, int32_t side_texel, int32_t x_px) {
  const auto sample = spec::sample(line, x_px);
  if (!sample) return kUntouched;
  const spec::Texel texel =
      spec::nearest_texel(*sample, side_texel, side_texel, SELVAGE_ADDRESS_CLAMP);
  return place_of(texel.s, texel.t);
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
    std::vector<uint32_t> row(static_cast<size_t>(side), kUntouched);
    for (size_t p = 0; p < bounds.size(); ++p) {
      if (y < bounds[p].top_px || y >= bounds[p].bottom_px) continue;
      const auto line = spec::scan_line(load.polygons[p], y);
      if (!line) continue;
      for (int32_t x = bounds[p].left_px; x < bounds[p].right_px; ++x) {
        const uint32_t pixel = model_pixel(*line, load.texture_side_texel, x);
        if (pixel != kUntouched) row[static_cast<size_t>(x)] = pixel;
      }
    }
    model.pixels.push_back(std::move(row));
    tick();
  }
  return model;
}

ErrorCount count_errors(const ModelRows& model, const Target& drawn, bool textures,
                        uint32_t carried_bits) {
  ErrorCount count;
  for (size_t r = 0; r < model.rows_px.size(); ++r) {
    const uint32_t* row = drawn.row(model.rows_px[r]);
    for (size_t x = 0; x < model.pixels[r].size(); ++x) {
      const bool expected = model.pixels[r][x] != kUntouched;
      const bool seen = row[x] != kUntouched;
      ++count.judged_px;
      count.covered_px += expected;
      count.missing_px += expected && !seen;
      count.extra_px += seen && !expected;
      const uint32_t difference = (row[x] ^ model.pixels[r][x]) & carried_bits;
      count.wrong_texels += textures && expected && seen && difference != 0;
    }
  }
  return count;
}

}  // namespace selvage::reports
