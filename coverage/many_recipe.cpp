#include "coverage/many_recipe.h"

#include <algorithm>
#include <span>
#include <utility>

namespace selvage::coverage {
namespace {

inline constexpr int32_t kBandRows = 16, kMostRows = 1 << 16;

// Wide enough for every profile: from the row above the highest vertex to the one below the lowest.
[[nodiscard]] BandRows rows_of(const selvage_polygon& polygon) {
  if (polygon.vertices == nullptr || polygon.count < 3) return {0, kMostRows};
  const std::span vertices{polygon.vertices, polygon.count};
  const auto [high, low] = std::ranges::minmax(vertices, {}, &selvage_vertex::y);
  return {(high.y >> 8) - 1, (low.y >> 8) + 2};
}

// The bands that some rows meet: [first, end), for they follow one another.
[[nodiscard]] std::pair<size_t, size_t> reach(const std::vector<BandRows>& bands, BandRows rows) {
  const auto meets = [&](const BandRows& band) {
    return band.first < rows.end && rows.first < band.end;
  };
  const auto first = std::ranges::find_if(bands, meets);
  const auto end = std::ranges::find_if_not(first, bands.end(), meets);
  return {first - bands.begin(), end - bands.begin()};
}

}  // namespace

ManyRecipe::ManyRecipe()
    : cut([](int32_t height_px, int32_t) {
        std::vector<BandRows> bands;
        for (int32_t row = 0; row < height_px; row += kBandRows) {
          bands.push_back({row, std::min(row + kBandRows, height_px)});
        }
        return bands;
      }) {}

namespace {

struct ManyCall {
  const selvage_image* target;
  const selvage_rect* clip;
  const selvage_polygon* polygons;
  size_t count;
  const selvage_options* options;
  int32_t threads;
  size_t* failed;
};

// Draws through a clip of nothing: only a status is left.
template <class Draw>
[[nodiscard]] selvage_status check(const ManyRecipe& recipe, const Draw& draw,
                                   const ManyCall& call) {
  const selvage_status of_call = selvage_draw_many(call.target, call.clip, nullptr, 0, call.options,
                                                   call.threads, nullptr, 0, nullptr);
  if (of_call != SELVAGE_OK) return of_call;
  if (call.count > 0 && call.polygons == nullptr) return SELVAGE_ERROR_POLYGONS_NULL;
  const selvage_rect nothing{0, 0, 0, 0};
  for (size_t i = 0; i < call.count && recipe.checks_first; ++i) {
    const auto& [vertices, count, texture] = call.polygons[i];
    const selvage_status status =
        draw(call.target, &nothing, vertices, count, texture, call.options);
    if (status == SELVAGE_OK) continue;
    if (call.failed != nullptr) *call.failed = recipe.tell(i);
    return status;
  }
  return SELVAGE_OK;
}

// The bands, each with its polygons.
template <class Draw>
[[nodiscard]] selvage_status draw_bands(const ManyRecipe& recipe, const Draw& draw,
                                        const ManyCall& call) {
  const int32_t height_px = call.target->height;
  const selvage_rect whole{0, 0, call.target->width, height_px};
  const selvage_rect visible = call.clip != nullptr ? *call.clip : whole;
  std::vector<selvage_polygon> all(call.polygons, call.polygons + call.count);
  recipe.prepare(all);
  const int32_t threads = call.threads == 0 ? recipe.all_threads : call.threads;
  const std::vector<BandRows> bands =
      threads == 1 ? std::vector<BandRows>{{0, height_px}} : recipe.cut(height_px, threads);
  for (size_t band = 0; band < bands.size(); ++band) {
    std::vector<selvage_polygon> mine;
    for (const selvage_polygon& polygon : all) {
      const auto [first, end] = reach(bands, rows_of(polygon));
      if (recipe.reaches(first, end, band)) mine.push_back(polygon);
    }
    if (threads != 1) recipe.order(mine);
    const selvage_rect strip{visible.left, std::max(visible.top, bands[band].first), visible.right,
                             std::min(visible.bottom, bands[band].end)};
    for (const auto& [vertices, count, texture] : mine) {
      const selvage_status status =
          draw(call.target, &strip, vertices, count, texture, call.options);
      if (status != SELVAGE_OK) return status;
    }
  }
  return SELVAGE_OK;
}

}  // namespace

spec::DrawMany draw_many_by(ManyRecipe recipe, const spec::Subject& subject) {
  return [recipe = std::move(recipe), draw = subject.draw](
             const selvage_image* target, const selvage_rect* clip, const selvage_polygon* polygons,
             size_t count, const selvage_options* options, int32_t threads, size_t* failed) {
    const ManyCall call{target, clip, polygons, count, options, threads, failed};
    const selvage_status status = check(recipe, draw, call);
    return status == SELVAGE_OK ? draw_bands(recipe, draw, call) : status;
  };
}

}  // namespace selvage::coverage
