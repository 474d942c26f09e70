// Near-ties: edges that miss a sample point, and coordinates that miss a texel border, by the least
// that the grid allows. Chance never makes them; a mapper that is off by one unit in its last place
// differs nowhere else.
#pragma once

#include <span>

#include "spec/generate_shapes.h"

namespace selvage::spec {

// Two vectors with components >= 0 and cross product 1, up to about reach_fx8 long: neighbours of
// the Stern-Brocot tree.
struct Neighbours {
  Point a, b;
};
[[nodiscard]] Neighbours random_neighbours(Random& random, int32_t reach_fx8);

// A triangle with an edge that passes a pixel centre at 1 / height of 1/256 px, on either side: the
// edge's ends and that centre span a doubled area of 1.
[[nodiscard]] Outline grazing(Random& random, const Frame& frame);

// Sets u, and perhaps v, of a triangle so that at some pixel centre of the frame the coordinate is
// a whole number of texels, or misses one by the least part of its denominator. Leaves coordinates
// alone for which no such numbers are in range.
void graze_a_texel(Random& random, const Frame& frame, std::span<selvage_vertex> triangle);

}  // namespace selvage::spec
