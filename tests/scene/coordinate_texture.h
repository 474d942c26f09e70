// Faces drawn from a texture whose texels are their own places, as their plans say.
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <vector>

#include "plane_face.h"
#include "scene/plan.h"

namespace selvage::scene {

inline constexpr Size kWideTarget{720, 540};  // rows wide enough to be stepped
inline constexpr std::array<uint8_t, 4> kNothing{255, 255, 255, 255};  // where nothing is drawn

[[nodiscard]] inline Scene scene_with_texture() {
  Scene scene;
  TextureImage image{kTextureSide_texel, kTextureSide_texel, {}, SELVAGE_ADDRESS_CLAMP};
  for (int t = 0; t < kTextureSide_texel; ++t) {
    for (int s = 0; s < kTextureSide_texel; ++s) {
      for (const int byte : {s & 255, s >> 8, t & 255, t >> 8}) {
        image.rgba.push_back(static_cast<uint8_t>(byte));
      }
    }
  }
  scene.textures.push_back(image);
  return scene;
}

struct Drawn {
  std::vector<std::array<uint8_t, 4>> pixels;
  selvage_choice choice{};
};

[[nodiscard]] inline Drawn draw(const Scene& scene, const ScreenFace& face, const Plan& plan) {
  Drawn drawn;
  drawn.pixels.resize(
      static_cast<size_t>(kWideTarget.width_px) * static_cast<size_t>(kWideTarget.height_px),
      kNothing);
  const selvage_image image{drawn.pixels.data(), kWideTarget.width_px, kWideTarget.height_px,
                            kWideTarget.width_px * 4, SELVAGE_RGBA8888};
  const selvage_texture texture{scene.textures[0].rgba.data(),
                                kTextureSide_texel,
                                kTextureSide_texel,
                                kTextureSide_texel * 4,
                                SELVAGE_RGBA8888,
                                SELVAGE_LAYOUT_ROWS,
                                nullptr};
  const std::vector<selvage_vertex> vertices = vertices_to_draw(face, plan);
  EXPECT_EQ(
      selvage_draw(&image, nullptr, vertices.data(), vertices.size(), &texture, &plan.options),
      SELVAGE_OK);
  EXPECT_EQ(selvage_choose(&image, nullptr, vertices.data(), vertices.size(), &texture,
                           &plan.options, &drawn.choice),
            SELVAGE_OK);
  return drawn;
}

}  // namespace selvage::scene
