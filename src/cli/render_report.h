// What `selvage render` tells about a picture: the choice for each face, and why.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>

#include "cli/bitmap.h"
#include "scene/draw.h"

namespace selvage::cli {

// What a face is drawn by: the mapper's own word, by selvage_choose, for the whole face.
struct FaceChoice {
  std::string method;
  int32_t segment_px = 0;
  double bound_texel = 0;
};
[[nodiscard]] FaceChoice choice_of(const scene::Scene& scene, const scene::Drawing& drawing,
                                   size_t face, Bitmap& target);

// A face each, in the order of the scene.
[[nodiscard]] nlohmann::ordered_json explanation(const scene::Scene& scene,
                                                 const scene::Drawing& drawing, double tolerance,
                                                 Bitmap& target);
[[nodiscard]] std::string explanation_text(const nlohmann::ordered_json& faces);

}  // namespace selvage::cli
