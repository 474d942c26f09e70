// A texture of two levels in turn, whose columns differ.
#pragma once

#include <cstdint>

#include "scene/scene.h"

namespace selvage::scene {

[[nodiscard]] inline TextureImage chequered(int32_t side_texel) {
  TextureImage image{side_texel, side_texel, {}, SELVAGE_ADDRESS_CLAMP};
  for (int32_t t = 0; t < side_texel; ++t) {
    for (int32_t s = 0; s < side_texel; ++s) {
      const uint8_t level = (s + t) % 2 ? 200 : 100;
      image.rgba.insert(image.rgba.end(), {level, static_cast<uint8_t>(s), 7, 255});
    }
  }
  return image;
}

}  // namespace selvage::scene
