// The lanes in perspective of a slab's rows, each by the map between its own two edges.
//
// At the centre of a pixel u = N / D, where N and D are what SpanMap weighs from the two edges:
// linear along a row, and quadratic in the row, for an edge's values and the weights of the other's
// are both linear in it. So three rows tell all of them exactly.
#pragma once

#include <optional>

#include "mapper/lanes.h"
#include "mapper/polygon.h"
#include "mapper/projective_plane.h"
#include "mapper/slab.h"

namespace selvage::mapper {

// As kPlaneRoundings and kPlaneErrorPerReach_fx32, with two sums more.
inline constexpr double kSlabRoundings = 10.5;
inline constexpr double kSlabErrorPerReach_fx32 = 0.4;
static_assert(kSlabErrorPerReach_fx32 < 1, "the reach itself serves as a bound");

// So many rows at least: fewer are drawn one by one.
inline constexpr int32_t kLeastFieldRows = 3;

// Of all pixels of the outline of a slab in `part`, of which the rows are the slab's. Empty where
// edges touch or cross, where the reach is too large, as ProjectivePlane's, or where numbers may
// not fit 128 bits.
[[nodiscard]] std::optional<ProjectiveField> ruled_field(const Slab& slab, const Polygon& outline,
                                                         const selvage_rect& part);

}  // namespace selvage::mapper
