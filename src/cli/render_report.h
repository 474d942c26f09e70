// What `selvage render` tells about a picture: the choice for each face, and why.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <utility>

#include "cli/bitmap.h"
#include "scene/draw.h"

namespace selvage::cli {

// What a face is drawn by: the mapper's own word, by selvage_choose, for the whole face. Filters
// other than nearest map exactly what they are given.
struct FaceChoice {
  std::string method, filter, kernel;
  int32_t segment_px = 0;
  double mapping_bound_texel = 0;  // from the map on the grid
};
[[nodiscard]] FaceChoice choice_of(const scene::Scene& scene, const scene::Drawing& drawing,
                                   size_t face, Bitmap& target);

// A face each, in the order of the scene.
[[nodiscard]] nlohmann::ordered_json explanation(const scene::Scene& scene,
                                                 const scene::Drawing& drawing, double tolerance,
                                                 Bitmap& target);
// A line for each face that has a texture, and one for the others together.
[[nodiscard]] std::string explanation_text(const nlohmann::ordered_json& faces);

// From here on rounding is warned of. A tolerance of 0 asks for the exact map on the grid, which
// all rounding moves: there from 1/16 texel on.
[[nodiscard]] constexpr double rounding_limit_texel(double tolerance_texel) {
  return tolerance_texel > 0 ? tolerance_texel : 1.0 / 16;
}

// Of the frames of one picture or animation: the faces that rounding alone may move by more than
// the tolerance.
class RoundingWarning {
 public:
  explicit RoundingWarning(double tolerance_texel)
      : limit_texel_(rounding_limit_texel(tolerance_texel)) {}

  void add(const scene::Scene& scene, const scene::Drawing& drawing);
  [[nodiscard]] std::string line() const;  // empty if there are none

 private:
  double limit_texel_, worst_texel_ = 0;
  std::string worst_;
  std::set<std::pair<size_t, size_t>> faces_;  // by object, and face of it
};

}  // namespace selvage::cli
