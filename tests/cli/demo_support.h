// Scenes for the tests of the demo. SELVAGE_SOURCE_TREE is the checkout.
#pragma once

#include <string>

#include "cli/raster.h"
#include "cli/scene_file.h"

namespace selvage::cli::test {

[[nodiscard]] inline scene::Scene station() {
  return read_scene(SELVAGE_SOURCE_TREE "/src/scene/shipped/station/station.json");
}

// The ball that keys turn is behind the camera; the one that is seen stands still. So what is seen
// does not depend on the time.
[[nodiscard]] inline std::string still_scene_text() {
  const std::string ball =
      R"({"file": ")" SELVAGE_SOURCE_TREE R"(/src/scene/shipped/station/ball.obj")";
  return R"({"camera": {"position": [0, 0.5, 4.2], "nearest": 0.5, "farthest": 100},
             "ambient": [0.5, 0.5, 0.5], "background": "#060914", "tolerance": 0.25, "objects": [)" +
         ball + R"(, "position": [0, 0, 50], "spin_deg": 40},)" + ball +
         R"(, "angle_deg": 25, "axis": [0.2, 1, 0]}]})";
}

// The pixels that the text at the lower edge leaves free, where the help is off.
[[nodiscard]] inline Raster above_text(const Raster& picture) {
  Raster part = picture;
  part.height_px = picture.height_px * 3 / 4;
  part.rgba.resize(static_cast<size_t>(part.height_px) * static_cast<size_t>(part.width_px) * 4);
  return part;
}

}  // namespace selvage::cli::test
