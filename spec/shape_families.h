// The families of outlines that the generator mixes. Positions may leave the accepted range; the
// generator clamps them, which keeps an outline y-monotone.
#pragma once

#include "spec/generate_shapes.h"

namespace selvage::spec {

// Near [0, size_px): whole pixels, pixel centres, 1/256 px beside either, anything between; now and
// then a little outside.
[[nodiscard]] int32_t position_fx8(Random& random, int32_t size_px);
// As above, but on one grid: multiples of step_fx8, or those plus half a pixel.
[[nodiscard]] int32_t grid_position_fx8(Random& random, int32_t size_px, int32_t step_fx8);

using Family = Outline (*)(Random&, const Frame&);

[[nodiscard]] Outline triangle(Random& random, const Frame& frame);
// On a half-pixel grid: edges run through pixel centres.
[[nodiscard]] Outline grid_triangle(Random& random, const Frame& frame);
// A thin triangle along pixel centres.
[[nodiscard]] Outline sliver(Random& random, const Frame& frame);
// A triangle of the least area there is, 1/2 of 1/65536 px^2, that starts on a pixel centre.
[[nodiscard]] Outline smallest(Random& random, const Frame& frame);
// At most a pixel high and as wide as the target, or turned.
[[nodiscard]] Outline needle(Random& random, const Frame& frame);
[[nodiscard]] Outline rectangle(Random& random, const Frame& frame);
// Parallelograms with slopes of 1, 1/2, 1/3 and their inverses; squares on their corners.
[[nodiscard]] Outline slanted(Random& random, const Frame& frame);
[[nodiscard]] Outline convex(Random& random, const Frame& frame);
// Two chains from top to bottom, which may cross and cross again.
[[nodiscard]] Outline chains(Random& random, const Frame& frame);
// No area: a point, a line, or a chain there and back.
[[nodiscard]] Outline flat(Random& random, const Frame& frame);
// Vertices at or near the ends of the accepted range, and an edge across the target.
[[nodiscard]] Outline far_off(Random& random, const Frame& frame);
// Not y-monotone, nearly always.
[[nodiscard]] Outline broken(Random& random, const Frame& frame);
// 0 .. 2 vertices.
[[nodiscard]] Outline too_few(Random& random, const Frame& frame);

}  // namespace selvage::spec
