// From lanes to the texel they show: at once, or, for near-ties, by exact integers.
#pragma once

#include <cstdint>

#include "mapper/exact_row.h"
#include "mapper/lanes.h"
#include "mapper/span.h"

namespace selvage::mapper {

// Not yet addressed.
struct TexelIndex {
  int32_t s, t;
};

[[nodiscard]] inline bool is_near_tie(int64_t lane_fx32, uint32_t margin_fx32) {
  return static_cast<uint32_t>(lane_fx32) >= 0U - margin_fx32;
}

// The exact texel under a lane of which one coordinate at least is a near-tie. Rare, and kept out
// of the loops.
[[nodiscard, gnu::noinline]] inline TexelIndex decide(const ExactMap& exact, int32_t px,
                                                      int32_t row, Lane lane,
                                                      uint32_t margin_fx32) {
  TexelIndex texel{static_cast<int32_t>(lane.u_fx32 >> kLaneFraction),
                   static_cast<int32_t>(lane.v_fx32 >> kLaneFraction)};
  const ExactRow from_here = exact.row_from(px, row);
  if (is_near_tie(lane.u_fx32, margin_fx32)) texel.s = from_here.u_texel(0, texel.s);
  if (is_near_tie(lane.v_fx32, margin_fx32)) texel.t = from_here.v_texel(0, texel.t);
  return texel;
}

[[nodiscard]] inline bool is_near_tie(Lane lane, uint32_t margin_fx32) {
  return is_near_tie(lane.u_fx32, margin_fx32) || is_near_tie(lane.v_fx32, margin_fx32);
}

// floor u and floor v at a pixel: those of the lanes, which are exact unless near-ties.
[[nodiscard]] inline TexelIndex texel_under(Lane lane, uint32_t margin_fx32, const ExactMap& exact,
                                            int32_t px, int32_t row) {
  if (is_near_tie(lane, margin_fx32)) [[unlikely]] {
    return decide(exact, px, row, lane, margin_fx32);
  }
  return {static_cast<int32_t>(lane.u_fx32 >> kLaneFraction),
          static_cast<int32_t>(lane.v_fx32 >> kLaneFraction)};
}

}  // namespace selvage::mapper
