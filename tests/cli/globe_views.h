// The globe that is shipped, seen from anywhere.
#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <vector>

#include "cli/scene_file.h"
#include "scene/draw.h"
#include "spec/random.h"
#include "tests/scene/index_picture.h"
#include "tests/scene/plane_face.h"

namespace selvage::cli::test {

// With the map that is shipped, whatever there is on this machine, or with another.
[[nodiscard]] inline scene::Scene read_globe(const std::string& map = SELVAGE_SCENE_FILES
                                             "/globe/earth.png") {
  return read_scene(SELVAGE_SCENE_FILES "/globe/globe.json", {{{"earth", map}}, {}});
}
inline constexpr scene::Size kGlobeSize{160, 120};

[[nodiscard]] inline scene::Scene globe_seen_from(uint64_t seed, scene::Scene scene) {
  spec::Random random(seed);
  scene.objects[0].motion.axis = scene::direction(random);
  scene.objects[0].motion.angle_deg = scene::real(random, 0, 360);
  scene.camera.position = scene::Vector3(0, 0, scene::real(random, 2, 6));
  scene.camera.up = scene::Vector3(scene::real(random, -1, 1), 1, 0);
  return scene;
}

// Texels that tell their own place.
inline void paint_places(scene::TextureImage& image) {
  for (int32_t t = 0; t < image.height_texel; ++t) {
    for (int32_t s = 0; s < image.width_texel; ++s) {
      uint8_t* texel = &image.rgba[static_cast<size_t>(t * image.width_texel + s) * 4];
      texel[0] = static_cast<uint8_t>(s & 0xff);
      texel[1] = static_cast<uint8_t>(s >> 8);
      texel[2] = static_cast<uint8_t>(t & 0xff);
      texel[3] = static_cast<uint8_t>(t >> 8);
    }
  }
}

// A globe of such texels, drawn exactly, and which face each pixel shows.
struct GlobePicture {
  struct Texel {
    int u, v;
  };
  scene::Drawing drawing;
  scene::IndexPicture index;
  std::vector<uint8_t> pixels;

  explicit GlobePicture(const scene::Scene& scene)
      : drawing(
            compose(scene, 0, kGlobeSize, {0, SELVAGE_FILTER_NEAREST}, scene::Hidden::kPainter)),
        index(draw_indices(drawing.pieces, drawing.view.faces, kGlobeSize)),
        pixels(static_cast<size_t>(kGlobeSize.width_px * kGlobeSize.height_px) * 4) {
    EXPECT_EQ(draw(scene, drawing,
                   {pixels.data(), kGlobeSize.width_px, kGlobeSize.height_px,
                    kGlobeSize.width_px * 4, SELVAGE_RGBA8888}),
              SELVAGE_OK);
  }

  [[nodiscard]] static size_t at(int32_t x_px, int32_t y_px) {
    return static_cast<size_t>(y_px * kGlobeSize.width_px + x_px);
  }
  [[nodiscard]] Texel texel(int32_t x_px, int32_t y_px) const {
    const uint8_t* p = &pixels[at(x_px, y_px) * 4];
    return {p[0] + 256 * p[1], p[2] + 256 * p[3]};
  }
};

}  // namespace selvage::cli::test
