#include "cli/demo_command_line.h"

#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

namespace selvage::cli {
namespace {

constexpr const char* kDemoText = R"(Examples:
  selvage demo
  selvage demo src/scene/shipped/station/station.json --size 1024x768

Keys:
  S, shift-S   faster, slower; below nothing, backward
  X, Y, Z      turn the scene's first object about that axis of the world
  space        turn it the other way
  arrows, +, - move the scene; nearer, farther
  F            the next filter: auto, nearest, four, bilinear, area
  M            the next mapper: exact, abrash56, abrash57. The historic ones draw the same faces on
               whole pixels, without depth and through the filter nearest
  D            the difference from the exact picture, four times as bright, and its pixels
  P            print the frame rate and the settings
  H            help on and off
  Esc, Q       quit

Exit codes: 0 fine; 2 wrong use, no window system, or a file that cannot be read.
)";

}  // namespace

CLI::App* add_demo(CLI::App& program, DemoOptions& options) {
  CLI::App* demo = program.add_subcommand("demo", "Show a scene in a window, and turn it by keys");
  demo->add_option("scene", options.scene,
                   "Scene: JSON, as 'selvage render --help' tells; the station that comes with "
                   "selvage if left out")
      ->type_name("FILE");
  demo->add_option("--size", options.size, "Size of the window at first")
      ->type_name("WxH")
      ->capture_default_str();
  demo->add_option("--frames", options.frames, "End after so many pictures; 0: when asked to")
      ->type_name("N")
      ->capture_default_str();
  demo->footer(kDemoText);
  return demo;
}

}  // namespace selvage::cli
