// The textures that faces are drawn from.
//
// The mapper copies texels and mixes nothing in, so the light is put into the texels beforehand: a
// face of one colour is drawn from a texture of one texel, a textured face in a light from a copy
// of the texture, each texel times that light. Light comes in 255 steps, so faces that reflect the
// same share one copy.
#pragma once

#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "scene/scene.h"
#include "scene/screen_face.h"
#include "selvage.h"

namespace selvage::scene {

class Paints {
 public:
  explicit Paints(const Scene& scene) : scene_(scene) {}

  // Good as long as this and the scene's textures are.
  [[nodiscard]] selvage_texture texture(const Paint& paint);

 private:
  using Texels = std::vector<uint8_t>;

  [[nodiscard]] const Texels& colour(const Colour& colour);
  [[nodiscard]] const Texels& lit_copy(size_t texture, const Light& light);

  const Scene& scene_;
  std::map<uint32_t, Texels> colours_;
  std::map<std::pair<size_t, Light>, Texels> lit_copies_;
};

}  // namespace selvage::scene
