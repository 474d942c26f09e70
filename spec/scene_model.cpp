#include "spec/scene_model.h"

#include <memory>
#include <string>
#include <utility>

#include "spec/law_tools.h"
#include "spec/model.h"

namespace selvage::spec {

SceneModel::SceneModel(const PolygonScene& scene, const Capabilities& claims)
    : scene_(scene), background_(scene.blank().pixel(0, 0)) {
  const Case& shown = scene.shown();
  const Rational accuracy = accuracy_of(claims);
  pixels_.resize(static_cast<size_t>(shown.target_width_px) *
                 static_cast<size_t>(shown.target_height_px));
  in_doubt_.resize(pixels_.size());
  for (size_t polygon = scene.count(); polygon-- > 0;) {  // the last one is on top
    const Case c = scene.case_of(polygon);
    const TexelAt texel_at = scene.texels_of(polygon);
    size_t index = 0;
    for (int32_t y = 0; y < c.target_height_px; ++y) {
      const ModelRow row(c, y);
      for (int32_t x = 0; x < c.target_width_px; ++x, ++index) {
        if (pixels_[index] || in_doubt_[index] || !is_visible(c, {x, y})) continue;
        in_doubt_[index] = is_in_doubt(claims.coverage_accuracy_fx16, c, {x, y});
        if (in_doubt_[index]) continue;
        const std::optional<Sample> exact = row.coordinates(x);
        if (exact) pixels_[index].emplace(c, Pixel{x, y}, *exact, texel_at, accuracy);
      }
    }
  }
}

bool SceneModel::is_allowed(size_t index, uint32_t value) const {
  if (in_doubt_[index]) return true;
  const std::optional<AllowedPixel>& allowed = pixels_[index];
  return allowed ? allowed->holds(value) : value == background_;
}

Comparison SceneModel::comparison_of(const Canvas& drawn) const {
  const Picture picture = scene_.picture_of(drawn);
  Comparison comparison{picture, picture, false};
  for (size_t i = 0; i < picture.pixels.size(); ++i) {
    if (is_allowed(i, picture.pixels[i].value_or(background_))) continue;
    comparison.wanted.pixels[i] = pixels_[i] ? MaybePixel(pixels_[i]->exact()) : MaybePixel();
  }
  return comparison;
}

Judgement SceneModel::judge(const std::string& what, const Canvas& drawn) const {
  const Case& c = scene_.shown();
  Judgement judgement;
  for (int32_t y = 0; y < c.target_height_px; ++y) {
    for (int32_t x = 0; x < c.target_width_px; ++x) {
      const auto index = static_cast<size_t>(judgement.judged_px++);
      const uint32_t value = drawn.pixel(x, y);
      if (is_allowed(index, value)) continue;
      Violation violation{.law = "SAME", .what = what, .x_px = x, .y_px = y, .shown = c};
      violation.scene = scene_.copies();
      violation.comparison = std::make_shared<const Comparison>(comparison_of(drawn));
      violation.allowed =
          pixels_[index] ? pixels_[index]->text() + " of the polygon on top" : "nothing";
      violation.drawn = scene_.describe(violation.comparison->drawn.at(x, y));
      judgement.violation = std::move(violation);
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
