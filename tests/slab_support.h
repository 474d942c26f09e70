// What tests of slabs share: those of many quads.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <vector>

#include "mapper/polygon.h"
#include "mapper/slab.h"
#include "spec/random.h"
#include "tests/span_support.h"

namespace selvage::mapper {

// A quad of any place and size, its corners rounded or far from where they were.
[[nodiscard]] inline std::vector<selvage_vertex> any_quad(spec::Random& random, bool affine) {
  const double side = random.pick({300, 3000, 30000, 300000, 3000000});
  const double turn = random.in(0, 628) / 100.0;
  const int32_t texels_fx16 = 1 << random.in(4, 30), nudge = random.pick({0, 1, 1, 200});
  const int32_t q = random.pick({1, 100, 1 << 20, 1 << 23}), depth = random.in(0, 100);
  std::vector<selvage_vertex> quad;
  for (int k = 0; k < 4; ++k) {
    const double at = turn + k * 1.5707963;
    const bool right = k == 1 || k == 2, below = k >= 2;
    selvage_vertex v{static_cast<int32_t>(std::lround(side * std::cos(at))),
                     static_cast<int32_t>(std::lround(side * std::sin(at))),
                     right ? texels_fx16 : 0, below ? texels_fx16 : 0, q};
    v.x += random.in(-nudge, nudge + 1);
    v.y += random.in(-nudge, nudge + 1);
    if (!affine) v.q = q + static_cast<int32_t>(int64_t{q} * depth * random.in(0, 100) / 10000);
    quad.push_back(v);
  }
  return quad;
}

// Calls visit(vertices, polygon, slab) for the slabs of many quads.
template <class Visit>
void for_each_slab(uint64_t quads, bool affine, const Visit& visit) {
  for (uint64_t seed = 1; seed <= quads; ++seed) {
    spec::Random random(seed);
    const std::vector<selvage_vertex> vertices = any_quad(random, affine);
    Polygon polygon;
    if (examine(vertices, &polygon) != SELVAGE_OK) continue;
    SlabWalk walk(polygon, part_of(polygon, kEverywhere));
    while (const auto slab = walk.next()) {
      ASSERT_NO_FATAL_FAILURE(visit(vertices, polygon, *slab)) << "seed " << seed;
    }
  }
}

}  // namespace selvage::mapper
