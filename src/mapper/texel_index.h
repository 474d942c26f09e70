// From lanes to the texel they show: at once, or, for near-ties, by exact integers.
#pragma once

#include <bit>
#include <cstdint>

#include "mapper/exact_row.h"
#include "mapper/lanes.h"

namespace selvage::mapper {

// Not yet addressed.
struct TexelIndex {
  int32_t s, t;
};

[[nodiscard]] inline bool is_near_tie(int64_t lane_fx32, uint32_t margin_fx32) {
  return static_cast<uint32_t>(lane_fx32) >= 0U - margin_fx32;
}

[[nodiscard]] inline bool is_near_tie(Lane lane, uint32_t margin_fx32) {
  return is_near_tie(lane.u_fx32, margin_fx32) || is_near_tie(lane.v_fx32, margin_fx32);
}

template <class Unsigned>
[[nodiscard]] inline TexelIndex decide_by(const ExactRow& exact, int32_t offset_px, Lane lane,
                                          uint32_t margin_fx32) {
  TexelIndex texel{static_cast<int32_t>(lane.u_fx32 >> kLaneFraction),
                   static_cast<int32_t>(lane.v_fx32 >> kLaneFraction)};
  const auto d =
      exact.d.step == 0 ? static_cast<Unsigned>(exact.d.start) : exact.d.at<Unsigned>(offset_px);
  if (is_near_tie(lane.u_fx32, margin_fx32)) {
    texel.s += reaches(exact.u.at<Unsigned>(offset_px), d, texel.s + 1) ? 1 : 0;
  }
  if (is_near_tie(lane.v_fx32, margin_fx32)) {
    texel.t += reaches(exact.v.at<Unsigned>(offset_px), d, texel.t + 1) ? 1 : 0;
  }
  return texel;
}

// By themselves, so that decide() is short.
[[nodiscard, gnu::noinline]] inline TexelIndex decide_long(const ExactRow& exact, int32_t offset_px,
                                                           Lane lane, uint32_t margin_fx32) {
  return decide_by<uint128>(exact, offset_px, lane, margin_fx32);
}
[[gnu::noinline]] inline void find_row(RowOnDemand& row, uint32_t margin_fx32) {
  row.find(std::countl_zero(margin_fx32));
}

// The exact texel under a lane of which one coordinate at least is a near-tie: its own or the next.
// Rare, and kept out of the loops.
[[nodiscard, gnu::noinline]] inline TexelIndex decide(RowOnDemand& row, int32_t offset_px,
                                                      Lane lane, uint32_t margin_fx32) {
  if (!row.is_known()) [[unlikely]] {
    find_row(row, margin_fx32);
  }
  if (!row.is_short()) return decide_long(row.get(), offset_px, lane, margin_fx32);
  return decide_by<uint64_t>(row.get(), offset_px, lane, margin_fx32);
}

// floor u and floor v at a pixel: those of the lanes, which are exact unless near-ties.
[[nodiscard]] inline TexelIndex texel_under(Lane lane, uint32_t margin_fx32, RowOnDemand& row,
                                            int32_t offset_px) {
  if (is_near_tie(lane, margin_fx32)) [[unlikely]] {
    return decide(row, offset_px, lane, margin_fx32);
  }
  return {static_cast<int32_t>(lane.u_fx32 >> kLaneFraction),
          static_cast<int32_t>(lane.v_fx32 >> kLaneFraction)};
}

}  // namespace selvage::mapper
