// How much of the area filter's work sums of a texture would spare.
#pragma once

#include <span>

#include "scene/scene.h"
#include "selvage.h"

namespace selvage::scene {

// To look a box up in sums costs about as much as visiting so many texels; mappers visit smaller
// boxes in any case.
inline constexpr double kLookingUp_texels = 128;

// About so many texels under the boxes of a face within the clip rectangle, less what looking these
// boxes up would cost. 0 for filters other than area.
[[nodiscard]] double spared_texels(const TextureImage& image,
                                   std::span<const selvage_vertex> vertices,
                                   const selvage_options& options, const selvage_rect& clip);

}  // namespace selvage::scene
