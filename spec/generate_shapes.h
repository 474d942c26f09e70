// Outlines for generated cases: where the vertices lie.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "spec/geometry.h"
#include "spec/random.h"

namespace selvage::spec {

using Outline = std::vector<Point>;

// The size of the target that an outline is made for.
struct Frame {
  int32_t width_px = 1, height_px = 1;
};

// An outline of some family, perhaps with ledges, repeated vertices or collinear runs added,
// shifted off the target, reversed, or started elsewhere. At most kMaxVertices vertices within the
// accepted range. All families but the one of broken outlines are y-monotone.
[[nodiscard]] Outline random_outline(Random& random, const Frame& frame);

}  // namespace selvage::spec
