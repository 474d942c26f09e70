// Texture coordinates and q for generated cases.
#pragma once

#include <span>

#include "selvage.h"
#include "spec/random.h"

namespace selvage::spec {

// Sets u and v of vertices that have their positions, each by a rule of its own or both by rules of
// one kind: random, on texel boundaries, an affine function of the position, extreme, constant,
// huge or tiny in scale.
void set_uv(Random& random, std::span<selvage_vertex> vertices, int32_t texture_width_texel,
            int32_t texture_height_texel);

// Sets q: mostly all equal, else in some ratio, at the ends of the range, or on a plane.
void set_q(Random& random, std::span<selvage_vertex> vertices);

}  // namespace selvage::spec
