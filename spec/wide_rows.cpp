#include "spec/wide_rows.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace selvage::spec {
void fit(std::vector<selvage_vertex>* vertices, int32_t selvage_vertex::*axis, int64_t to_least,
         int64_t to_greatest) {
  const auto [low, high] = std::ranges::minmax(*vertices, {}, axis);
  const int64_t from = low.*axis, extent = std::max(int64_t{high.*axis} - from, int64_t{1});
  for (selvage_vertex& v : *vertices) {
    v.*axis = static_cast<int32_t>(to_least + (v.*axis - from) * (to_greatest - to_least) / extent);
  }
}

Case made_wide(const Case& c, Choices& choices) {
  Case wide = c;
  wide.has_clip = choices.pick(0, 4) == 0;
  wide.clip = {choices.pick(0, 60), 0, choices.pick(60, 400), 100};
  wide.target_width_px = choices.pick(160, 400);
  wide.target_height_px = choices.pick(1, 6);
  const int32_t beyond = choices.pick(0, 2) * choices.pick(0, 1 << 16);
  fit(&wide.vertices, &selvage_vertex::x, -beyond,
      int64_t{wide.target_width_px} * SELVAGE_SUBPIXELS + beyond);
  fit(&wide.vertices, &selvage_vertex::y, -choices.pick(0, 512),
      int64_t{wide.target_height_px} * SELVAGE_SUBPIXELS + choices.pick(0, 512));
  const int32_t base = 1 << choices.pick(4, 24);
  const int32_t spread = std::max(base >> choices.pick(0, 10), 1);
  const int halvings = choices.pick(0, 16);
  for (selvage_vertex& v : wide.vertices) {
    v.q = base - v.q % spread;
    v.u >>= halvings;
    v.v >>= halvings;
  }
  return wide;
}

}  // namespace selvage::spec
