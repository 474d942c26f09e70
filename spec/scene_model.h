// What law SAME's scene may look like where no drawing of it tells: by the model, of a mapper that
// claims an accuracy, of texels or of coverage.
#pragma once

#include <optional>
#include <vector>

#include "spec/allowed_pixel.h"
#include "spec/canvas.h"
#include "spec/laws.h"
#include "spec/polygon_scene.h"

namespace selvage::spec {

class SceneModel {
 public:
  // Of accuracies that are claimed; that of texels is below 1.
  SceneModel(const PolygonScene& scene, const Capabilities& claims);

  // Whether each pixel is one of the polygon on top there, or as it was, and every byte beside.
  [[nodiscard]] Judgement judge(const std::string& what, const Canvas& drawn) const;

 private:
  [[nodiscard]] bool is_allowed(size_t index, uint32_t value) const;
  // Alike but for the pixels that are not.
  [[nodiscard]] Comparison comparison_of(const Canvas& drawn) const;

  const PolygonScene& scene_;
  uint32_t background_;
  std::vector<std::optional<AllowedPixel>> pixels_;  // that some polygon covers
  std::vector<bool> in_doubt_;  // which the polygon on top, or one above it, may draw or not
};

}  // namespace selvage::spec
