#include <cmath>
#include <numbers>

#include "reports/bench/curves.h"

namespace selvage::reports {

namespace {

// A target that is all one square of the texture, turned about their middles.
Workload turned(double degrees) {
  constexpr int32_t target_px = 1024, texture_texel = 2048;
  const double angle = degrees * std::numbers::pi / 180;
  const double cosine = std::cos(angle), sine = std::sin(angle);
  Workload load;
  load.target_side_px = target_px;
  load.texture_side_texel = texture_texel;
  auto& polygon = load.polygons.emplace_back();
  for (const auto& [x, y] : {std::pair(0, 0), std::pair(target_px, 0),
                             std::pair(target_px, target_px), std::pair(0, target_px)}) {
    const double dx = x - target_px / 2, dy = y - target_px / 2;
    const auto coordinate = [](double texel) {
      return static_cast<int32_t>(
          std::lround((texture_texel / 2 + texel) * int32_t{SELVAGE_SUBTEXELS}));
    };
    polygon.push_back({x * SELVAGE_SUBPIXELS, y * SELVAGE_SUBPIXELS,
                       coordinate(cosine * dx - sine * dy), coordinate(sine * dx + cosine * dy),
                       1});
  }
  return load;
}

}  // namespace

Curve curve_direction() {
  Curve curve;
  curve.id = "direction";
  curve.title = "Cost against direction, by layout";
  curve.description =
      "a target of 1024 x 1024 px, one texel of a texture of 2048 x 2048 a pixel, along its rows "
      "at "
      "0 degrees and down its columns at 90; from rows at a pitch of 8192 bytes, and from what "
      "selvage_prepare makes of them";
  curve.axis = "degrees between the target's rows and the texture's";
  curve.xs = {1, 2, 5, 10, 23, 45, 67, 80, 85, 89, 90};
  curve.load_at = turned;
  for (const Subject& subject : subjects_in_layouts())
    curve.series.push_back({subject.id, [subject](double) { return subject; }});
  return curve;
}

}  // namespace selvage::reports
