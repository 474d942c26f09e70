// Cases of any profile out of seeds.
#pragma once

#include <cstdint>

#include "spec/case.h"

namespace selvage::spec {

// The case of a seed in a profile: the same on every machine. generate(seed) as the profile takes
// it; of the historic ones, some are changed toward what is hard for 16.16 steps in whole columns:
//
//   long      a target of hundreds of columns or rows, the outline stretched over it, where what
//             steps lose adds up
//   block     a rectangle that is not transformed, or is so but for one thing; of any size, and as
//             likely as not cut off by the target
//   grazing   texture coordinates shifted so that the profile's own arithmetic ends on the boundary
//             of a texel, or one unit below it, at some pixel: there a single unit shows
[[nodiscard]] Case generate(uint64_t seed, selvage_profile id);

}  // namespace selvage::spec
