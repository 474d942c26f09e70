// How much of its derived bound a profile's arithmetic uses.
#pragma once

#include <cstdint>

#include "spec/case.h"
#include "spec/exact.h"
#include "spec/reach.h"

namespace selvage::stability {

// One coordinate of a pixel: what it is exactly, by the profile's own conventions, and how far
// below and above the arithmetic may take it. Texels.
struct Coordinate {
  spec::Rational exact, below, above;
};

// Texel `drawn` of `size_texel` is shown by the coordinates whose floor, `rounding_texel` added,
// is addressed to it. The distance from the exact coordinate to the nearest of these, divided by
// the bound on that side: 0 where the exact coordinate shows that texel itself, above 1 where the
// arithmetic went too far.
[[nodiscard]] double part_of_bound(const Coordinate& coordinate, int32_t drawn, int32_t size_texel,
                                   selvage_address address, const spec::Rational& rounding_texel);

// The greater of u's and v's at a pixel of a case of a historic profile.
[[nodiscard]] double part_of_bound(const spec::Case& c, const spec::Reach& reach,
                                   const spec::Texel& drawn);

}  // namespace selvage::stability
