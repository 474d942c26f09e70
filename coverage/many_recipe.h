// Many polygons by recipe: the steps of drawing in bands, each of which a wrong mapper may replace.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "spec/subject.h"

namespace selvage::coverage {

// Rows [first, end).
struct BandRows {
  int32_t first, end;
};

struct ManyRecipe {
  // The bands of a target so many rows high.
  std::function<std::vector<BandRows>(int32_t height_px, int32_t threads)> cut;
  // Which polygons there are to draw.
  std::function<void(std::vector<selvage_polygon>&)> prepare = [](auto&) {};
  // A polygon that reaches the bands [first, end) is drawn in this one.
  std::function<bool(size_t first, size_t end, size_t band)> reaches =
      [](size_t first, size_t end, size_t band) { return first <= band && band < end; };
  // The polygons of a band, in the order of drawing.
  std::function<void(std::vector<selvage_polygon>&)> order = [](auto&) {};

  // All polygons are checked before the first is drawn; which one is told of polygon i.
  bool checks_first = true;
  std::function<size_t(size_t i)> tell = [](size_t i) { return i; };
  // As many threads as the machine has.
  int32_t all_threads = 4;

  ManyRecipe();
};

// One band after another, each polygon by the subject's own call; with one thread, no bands.
[[nodiscard]] spec::DrawMany draw_many_by(ManyRecipe recipe, const spec::Subject& subject);

}  // namespace selvage::coverage
