#include "spec/scene_model.h"

#include <string>
#include <utility>

#include "spec/law_tools.h"
#include "spec/model.h"

namespace selvage::spec {
namespace {

[[nodiscard]] bool is_visible(const Case& c, int32_t x, int32_t y) {
  return !c.has_clip ||
         (c.clip.left <= x && x < c.clip.right && c.clip.top <= y && y < c.clip.bottom);
}

[[nodiscard]] std::string value_text(const Case& c, uint32_t value) {
  return c.format == SELVAGE_RGBA8888 ? describe_colour(value) : "value " + std::to_string(value);
}

}  // namespace

SceneModel::SceneModel(const PolygonScene& scene, const Rational& accuracy)
    : scene_(scene), background_(scene.blank().pixel(0, 0)) {
  Case c = scene.shown();
  pixels_.resize(static_cast<size_t>(c.target_width_px) * static_cast<size_t>(c.target_height_px));
  for (size_t polygon = scene.count(); polygon-- > 0;) {  // the last one is on top
    c.vertices = scene.outline(polygon);
    const TexelAt texel_at = scene.texels_of(polygon);
    size_t index = 0;
    for (int32_t y = 0; y < c.target_height_px; ++y) {
      const ModelRow row(c, y);
      for (int32_t x = 0; x < c.target_width_px; ++x, ++index) {
        if (pixels_[index] || !is_visible(c, x, y)) continue;
        const std::optional<Sample> exact = row.coordinates(x);
        if (exact) pixels_[index].emplace(c, Pixel{x, y}, *exact, texel_at, accuracy);
      }
    }
  }
}

bool SceneModel::is_allowed(size_t index, uint32_t value) const {
  const std::optional<AllowedPixel>& allowed = pixels_[index];
  return allowed ? allowed->holds(value) : value == background_;
}

Judgement SceneModel::judge(const std::string& what, const Canvas& drawn) const {
  const Case& c = scene_.shown();
  Judgement judgement;
  for (int32_t y = 0; y < c.target_height_px; ++y) {
    for (int32_t x = 0; x < c.target_width_px; ++x) {
      const size_t index = judgement.judged_px++;
      const uint32_t value = drawn.pixel(x, y);
      if (is_allowed(index, value)) continue;
      const std::optional<AllowedPixel>& allowed = pixels_[index];
      judgement.violation =
          violation_at("SAME", what, c, x, y,
                       allowed ? allowed->text() + " of the polygon on top" : "nothing", value);
      judgement.violation->drawn = value == background_ ? "nothing" : value_text(c, value);
      judgement.violation->scene = scene_.copies();
      return judgement;
    }
  }
  if (!drawn.guards_are_intact()) {
    judgement.violation =
        violation_of_call("SAME", what, c, "the bytes beside the pixels as they were", "others");
  }
  return judgement;
}

}  // namespace selvage::spec
