// The textures that faces are drawn from.
//
// The mapper copies texels and mixes nothing in, so the light is put into the texels beforehand: a
// face of one colour is drawn from a texture of one texel, a textured face in a light from a copy
// of the texture, each texel times that light. Light comes in 255 steps, so faces that reflect the
// same share one copy, and of a copy only what is asked for is lit. Textures that are drawn as they
// are get sums for the area filter when these pay (texture_sums.h).
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <list>
#include <map>
#include <memory>
#include <vector>

#include "scene/scene.h"
#include "scene/screen_face.h"
#include "scene/texture_sums.h"
#include "selvage.h"

namespace selvage::scene {

// Textures with sums take no more than this at once.
inline constexpr size_t kSumsBytes = size_t{256} << 20;

class Paints {
 public:
  [[nodiscard]] static int64_t no_clock() { return 0; }

  // Copies are kept while all of them have at most so many bytes, and the last one always. Lighting
  // is timed by the clock.
  explicit Paints(const Scene& scene, size_t most_bytes = std::numeric_limits<size_t>::max(),
                  Clock now_ns = no_clock)
      : scene_(scene), most_bytes_(most_bytes), now_ns_(now_ns), sums_(kSumsBytes, now_ns) {}

  // With all texels, or in a light only those of that rectangle. Good as long as this and the
  // scene's textures are, and copies are not too many.
  [[nodiscard]] selvage_texture texture(const Paint& paint);
  // Sums would spare the drawing so many texels (box_work.h).
  [[nodiscard]] selvage_texture texture(const Paint& paint, const selvage_rect& texels,
                                        double spared_texels = 0);

  // What lighting has cost until now.
  [[nodiscard]] int64_t light_ns() const { return light_ns_; }
  [[nodiscard]] int64_t lit_texels() const { return lit_texels_; }
  [[nodiscard]] const TextureSums& sums() const { return sums_; }

 private:
  struct Copy {
    size_t texture;
    Light light;
    size_t bytes;
    std::unique_ptr<uint8_t[]> rgba;  // of the whole texture; set within `lit`
    selvage_rect lit;
  };

  [[nodiscard]] const std::vector<uint8_t>& colour(const Colour& colour);
  [[nodiscard]] Copy& copy_of(size_t texture, const Light& light);
  void light_texels(Copy& copy, const selvage_rect& texels);

  const Scene& scene_;
  size_t most_bytes_, bytes_ = 0;
  Clock now_ns_;
  int64_t light_ns_ = 0, lit_texels_ = 0;
  std::map<uint32_t, std::vector<uint8_t>> colours_;
  std::list<Copy> copies_;  // the one that was used last in front
  TextureSums sums_;
};

}  // namespace selvage::scene
