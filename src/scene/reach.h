// The texels that a face may show.
#pragma once

#include "scene/plan.h"
#include "scene/scene.h"
#include "selvage.h"

namespace selvage::scene {

// Every texel that selvage_draw may read for a textured face within its plan, as columns and rows
// of the texture. u and v are means of the corners', give or take the tolerance; filters mix in
// texels beside them, area as many as half of the greatest footprint. Where the texture repeats
// within, it is all of it.
[[nodiscard]] selvage_rect reach_texel(const TextureImage& image, const ScreenFace& face,
                                       const Plan& plan);

}  // namespace selvage::scene
