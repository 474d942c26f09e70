// All that a picture is made from.
#pragma once

#include <cstdint>
#include <vector>

#include "scene/camera.h"
#include "scene/colour.h"
#include "scene/lighting.h"
#include "scene/object.h"
#include "selvage.h"

namespace selvage::scene {

struct TextureImage {
  int32_t width_texel = 0, height_texel = 0;
  std::vector<uint8_t> rgba;  // rows without padding, the top one first
  selvage_address address = SELVAGE_ADDRESS_WRAP;
};

struct Scene {
  std::vector<Object> objects;
  std::vector<TextureImage> textures;
  Lighting lighting;
  Camera camera;
  Colour background;
  double tolerance_texel = 0;
};

}  // namespace selvage::scene
