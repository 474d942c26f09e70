// One axis of a box, in texels.
#pragma once

#include <cstdint>

#include "mapper/filter_point.h"
#include "mapper/number.h"

namespace selvage::mapper {

// The texels that a box may take parts of, wherever in the first of them it begins. Of the first it
// takes all but `part_fx8`, for no side is less than a texel.
struct BoxSide {
  int32_t first_texel, texels;
  int32_t part_fx8, side_fx8;

  [[nodiscard]] static BoxSide of(int32_t begin_fx8, int32_t side_fx8) {
    return {begin_fx8 >> kGridBits, ((side_fx8 + kTexel_fx8 - 2) >> kGridBits) + 1,
            begin_fx8 & (kTexel_fx8 - 1), side_fx8};
  }
  [[nodiscard]] bool is_inside(int32_t size_texel) const {
    return first_texel >= 0 && first_texel <= size_texel - texels;
  }
};

// As far into the first period as into its own: mostly it is the first.
[[nodiscard]] inline int32_t in_first_period(int32_t begin_fx8, int32_t size_texel) {
  const int64_t period_fx8 = int64_t{size_texel} * kTexel_fx8;
  if (0 <= begin_fx8 && begin_fx8 < period_fx8) return begin_fx8;
  return static_cast<int32_t>(begin_fx8 - floor_div(begin_fx8, period_fx8) * period_fx8);
}

}  // namespace selvage::mapper
