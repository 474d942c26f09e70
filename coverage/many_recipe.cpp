#include "coverage/many_recipe.h"

#include <algorithm>
#include <span>
#include <utility>

namespace selvage::coverage {
namespace {

inline constexpr int32_t kBandRows = 16;

// Wide enough for every profile: from the row above the highest vertex to the one below the lowest.
[[nodiscard]] BandRows rows_of(const selvage_polygon& polygon) {
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

spec::DrawMany draw_many_by(ManyRecipe recipe, const spec::Subject& subject) {
  return [recipe = std::move(recipe), draw = subject.draw](
             const selvage_image* target, const selvage_rect* clip, const selvage_polygon* polygons,
             size_t count, const selvage_options* options, int32_t threads) -> selvage_status {
    std::vector<selvage_polygon> all(polygons, polygons + count);
    recipe.prepare(all);
    const selvage_rect whole{0, 0, target->width, target->height};
    const selvage_rect visible = clip != nullptr ? *clip : whole;
    const std::vector<BandRows> bands = threads == 1 ? std::vector<BandRows>{{0, target->height}}
                                                     : recipe.cut(target->height, threads);
    for (size_t band = 0; band < bands.size(); ++band) {
      std::vector<selvage_polygon> mine;
      for (const selvage_polygon& polygon : all) {
        const auto [first, end] = reach(bands, rows_of(polygon));
        if (recipe.reaches(first, end, band)) mine.push_back(polygon);
      }
      if (threads != 1) recipe.order(mine);
      const selvage_rect strip{visible.left, std::max(visible.top, bands[band].first),
                               visible.right, std::min(visible.bottom, bands[band].end)};
      for (const selvage_polygon& p : mine) {
        const selvage_status status = draw(target, &strip, p.vertices, p.count, p.texture, options);
        if (status != SELVAGE_OK) return status;
      }
    }
    return SELVAGE_OK;
  };
}

}  // namespace selvage::coverage
