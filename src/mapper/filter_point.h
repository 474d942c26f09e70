// The coordinate stage of the filters: (u, v) in steps of 1/256 texel, exactly.
//
// Lanes are floored 8 bits below the texel. They are one-sided, so the same test as for texels
// finds those that may be too low, with 8 bits of fraction less; these are decided by integers.
#pragma once

#include <algorithm>
#include <cstdint>

#include "mapper/exact_row.h"
#include "mapper/lanes.h"
#include "mapper/span.h"

namespace selvage::mapper {

inline constexpr int kGridBits = 8;  // 1/256 texel
inline constexpr int32_t kTexel_fx8 = 1 << kGridBits;
inline constexpr int kGridFraction = kLaneFraction - kGridBits;  // bits of a lane below the grid
inline constexpr int32_t kLeastPoint_fx8 = -(1 << (kTexelBits - kTexelFraction + kGridBits));

// floor(256 (u - 1/2)) and floor(256 (v - 1/2)): texel centres are whole texels here.
struct FilterPoint {
  int32_t u_fx8, v_fx8;
};

// A lane may be low by more than a step of the grid, but only where the ratio of q is about
// 2^23 and above: all pixels are decided by integers then, at most three steps away
// (spec/proofs/filter_grid.g).
static_assert(kWidestMargin_fx32 >> kGridFraction <= 2, "a point is found in a few comparisons");
// A boundary in 1/256 texel times the denominator over 256 is as long as one in texels times the
// denominator: SpanMap's bound.
static_assert(kDenominatorBits - kGridBits + kTexelBits - kTexelFraction + kGridBits <= 127);

// floor(256 n / d) from one that is too low by little, if at all. Boundaries lie in the range of
// coordinates, so that products fit.
[[nodiscard]] inline int32_t decide_fx8(int128 n, int128 d, int32_t low_fx8) {
  const int128 step = d >> kGridBits;  // exact: d is a multiple of 2^16
  int32_t point = std::max(low_fx8, kLeastPoint_fx8);
  while (point < -kLeastPoint_fx8 && n >= step * (point + 1)) ++point;
  return point;
}

[[nodiscard]] inline bool is_near_grid(int64_t lane_fx32, uint32_t margin_fx32) {
  constexpr uint32_t kGridStep = 1U << kGridFraction;
  return (static_cast<uint32_t>(lane_fx32) & (kGridStep - 1)) + margin_fx32 >= kGridStep;
}

// Rare, and kept out of the loop.
[[nodiscard, gnu::noinline]] inline FilterPoint decide_point(const ExactMap& map, const Span& span,
                                                             int32_t px, FilterPoint low) {
  const ExactRow row = map.row_from(px, span.row);
  const auto d = static_cast<int128>(row.d.start);
  return {decide_fx8(static_cast<int128>(row.u.start), d, low.u_fx8),
          decide_fx8(static_cast<int128>(row.v.start), d, low.v_fx8)};
}

// The lanes at a pixel of a span, whichever they are, and how low they may be.
[[nodiscard]] inline Lane lane_at(const AffineField& lanes, const Span& span, int32_t px) {
  return lanes.at(px, span.row);
}
[[nodiscard]] inline Lane lane_at(const DividedLanes& lanes, const Span& span, int32_t px) {
  return lanes.at(px - span.left_px);
}
[[nodiscard]] inline uint32_t margin_of(const AffineField& lanes) { return lanes.margin_fx32; }
[[nodiscard]] inline uint32_t margin_of(const DividedLanes& lanes) { return lanes.margin_fx32(); }

// A pixel of a span, by its lanes and its exact map.
template <class Lanes>
[[nodiscard]] inline FilterPoint filter_point(const ExactMap& map, const Span& span,
                                              const Lanes& lanes, int32_t px) {
  const Lane lane = lane_at(lanes, span, px);
  FilterPoint point{static_cast<int32_t>(lane.u_fx32 >> kGridFraction),
                    static_cast<int32_t>(lane.v_fx32 >> kGridFraction)};
  const uint32_t margin = margin_of(lanes);
  if (is_near_grid(lane.u_fx32, margin) || is_near_grid(lane.v_fx32, margin)) [[unlikely]] {
    point = decide_point(map, span, px, point);
  }
  return {point.u_fx8 - kTexel_fx8 / 2, point.v_fx8 - kTexel_fx8 / 2};
}

}  // namespace selvage::mapper
