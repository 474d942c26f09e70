// `selvage render`: pictures of a scene, to PNG or animated PNG.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "cli/console.h"

namespace selvage::cli {

struct RenderOptions {
  std::string scene;                  // JSON
  std::string output;                 // .png, or .apng for an animation
  std::vector<std::string> textures;  // MATERIAL=FILE
  std::string size = "640x480";
  std::string filter = "auto";
  std::string tolerance;  // texels; empty: what the scene says
  std::string hidden = "scan-line";
  int32_t frames = 1;
  double start_s = 0, frames_per_s = 25;
  bool explain = false, stats = false, json = false;
};

int run_render(const RenderOptions& options, const Console& console);

}  // namespace selvage::cli
