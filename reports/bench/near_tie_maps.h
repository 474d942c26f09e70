// Random maps with near-ties, to search for those that cost more than the adversarial items.
#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "reports/bench/outlines.h"
#include "selvage.h"

namespace selvage::reports {

// Polygons lie in a target of so many pixels, or cross it, and show texels of a texture of so many
// a side.
inline constexpr int32_t kMapWidth_px = 1024, kMapHeight_px = 256, kMapTexture_texel = 512;

struct NearTieMap {
  std::string description;  // by 1/8 texel: its slopes are multiples of that a pixel
  Polygon hard;             // many samples, or all, on boundaries between texels or next to them
  std::array<Polygon, 3> ordinary;  // the same map, moved off them
  selvage_address address = SELVAGE_ADDRESS_CLAMP;
};

// The same for the same seed. Triangles and quads, in a plane or not, narrow or wide, some reaching
// far beyond the target; affine or in perspective; rarely as deep as a floor, for what is deep has
// few near-ties; about the texture's middle or about its edges and beyond them.
[[nodiscard]] NearTieMap near_tie_map(uint64_t seed);

}  // namespace selvage::reports
