// The greatest footprint of a map that is ruled by a face's edges (README.md, "The filter").
#pragma once

#include <span>

#include "selvage.h"

namespace selvage::scene {

// Holds the roundings in double of the bounds here, which cancellation may enlarge.
inline constexpr double kFootprintSlack = 1 + 0x1p-20;

// Not below |du/dx| + |du/dy|, nor the same of v, anywhere on a y-monotone face. Infinite where it
// has no area, or a row between two corners' heights is nearly without width.
[[nodiscard]] double ruled_texels_per_px_bound(std::span<const selvage_vertex> vertices);

}  // namespace selvage::scene
