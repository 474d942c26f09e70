// `selvage demo`: a scene in a window, that keys turn and move.
#pragma once

#include <cstdint>
#include <string>

#include "cli/console.h"

namespace selvage::cli {

struct DemoOptions {
  std::string scene;  // JSON; empty: the station that comes with the program
  std::string size = "640x480";
  int32_t frames = 0;  // ends after so many; 0: when asked to
};

int run_demo(const DemoOptions& options, const Console& console);

}  // namespace selvage::cli
