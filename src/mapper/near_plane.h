// A plane near a polygon that lies in none, as those do whose corners were rounded to the grid.
//
// Along each edge, and from edge to edge along each row, u and v are linear: so is what they are
// off a plane, which therefore lies between the least and the most that they are off it at the
// vertices. Lanes of the plane, lowered, with a margin for that, show most texels; which plane it
// is does not matter, but that a near one leaves less in doubt.
#pragma once

#include <cstdint>
#include <optional>

#include "mapper/lanes.h"
#include "mapper/number.h"
#include "mapper/polygon.h"

namespace selvage::mapper {

// What is further off its plane is drawn by the maps of its rows: near-ties would be many. 1/128
// texel: the corners of what is not minified are off by less.
inline constexpr int64_t kMostNearMargin_fx32 = int64_t{1} << (kLaneFraction - 7);
static_assert(kMostNearMargin_fx32 <= kWidestMargin_fx32);
// And what is so wide that each coordinate may have a near-tie in fewer rows: to decide it costs
// more than the maps of so many.
inline constexpr int64_t kLeastRowsPerNearTie = 5;

// In bits of texels a pixel: of what is steeper, a corner is rounded by 1/32 texel.
inline constexpr int kNearStepBits = 4;
// A margin counts floors, which lack less than a unit (spec/proofs/near_plane.g).
inline constexpr int64_t kNearTruncation_fx32 = 1;
// Lanes at vertices are found in 1/256 of 2^-32 texel.
static_assert(kTexelBits + kLaneFraction - kTexelFraction + kSubpixelBits < 61 &&
              kLaneFraction + kNearStepBits + kPositionBits + 1 < 62);

// The lanes of all pixels of an affine polygon that lie in `part`, a part_of() it that is not
// empty, as those of a plane; empty where none is near enough.
[[nodiscard]] std::optional<AffineField> near_plane(const Polygon& polygon,
                                                    const selvage_rect& part);

}  // namespace selvage::mapper
