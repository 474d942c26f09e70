#include "cli/render_command_line.h"

#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

namespace selvage::cli {
namespace {

constexpr const char* kRenderText = R"(Examples:
  selvage render src/scene/shipped/station/station.json -o station.png --size 640x480
  selvage render src/scene/shipped/station/station.json -o out.png --tolerance 0.25 --explain --stats
  selvage render src/scene/shipped/station/station.json -o frame.png --frames 50 --rate 25
  selvage render src/scene/shipped/globe/globe.json -o globe.apng --frames 100 --texture earth=earth.jpg

A scene:
  {"camera": {"position": [0, 1, 4], "target": [0, 0, 0], "up": [0, 1, 0], "view_deg": 45,
              "nearest": 0.125, "farthest": 1000},
   "ambient": [0.3, 0.3, 0.3], "lamps": [{"towards": [1, 1, 1], "level": [0.8, 0.8, 0.7]}],
   "background": "#101020", "tolerance": 0.25,
   "objects": [{"file": "ball.obj", "position": [0, 0, 0], "velocity": [0, 0, 0],
                "axis": [0, 1, 0], "angle_deg": 0, "spin_deg": 30, "scale": 1,
                "two_sided": false, "shading": {"steel": "ambient"},
                "textures": {"map": "/usr/share/xplanet/images/earth.jpg"}}]}
Only "objects" with a "file" each is needed: Wavefront OBJ, of plane convex faces that run
anticlockwise as seen from outside. Materials: Kd, map_Kd (PNG or JPEG) and illum, 0 for colours as
they are, 1 and more for light. "textures" take the place of materials' own pictures where their
files are there. velocity and spin_deg are per second. Several frames go into one animation, x.apng,
or into files of their own, x-00001.png and so on.

Exit codes: 0 fine; 2 wrong use, or a file that cannot be read or written.
)";

// Which picture of the scene, and where it goes.
void add_picture_options(CLI::App& render, RenderOptions& options) {
  render.add_option("scene", options.scene, "Scene: JSON, see below")
      ->required()
      ->type_name("FILE");
  render
      .add_option("-o,--output", options.output,
                  "PNG to write, or animated PNG (.apng); - is the standard output")
      ->required()
      ->type_name("FILE");
  render.add_option("--size", options.size, "Size of the picture")
      ->type_name("WxH")
      ->capture_default_str();
  render.add_option("--frames", options.frames, "Draw so many, one after another")
      ->type_name("N")
      ->capture_default_str();
  render.add_option("--time", options.start_s, "Time of the first frame, s")
      ->type_name("T")
      ->capture_default_str();
  render.add_option("--rate", options.frames_per_s, "Frames a second")
      ->type_name("R")
      ->capture_default_str();
}

// What it is drawn by.
void add_drawing_options(CLI::App& render, RenderOptions& options) {
  render
      .add_option("--filter", options.filter,
                  "auto (nearest where magnified, area where minified), nearest, four, bilinear "
                  "or area")
      ->type_name("NAME")
      ->capture_default_str();
  render
      .add_option(
          "--tolerance", options.tolerance,
          "How far u and v may be off, in texels, by mapping and by rounding to the grid; what "
          "the scene says if left out. Where rounding alone may be more, a warning says so")
      ->type_name("TEXELS");
  render
      .add_option("--hidden", options.hidden,
                  "What hides what: scan-line (exact, at every pixel) or painter (by faces)")
      ->type_name("WAY")
      ->capture_default_str();
  render
      .add_option("--texture", options.textures,
                  "Another picture in the place of a material's texture; may be given again")
      ->type_name("MATERIAL=FILE");
}

}  // namespace

CLI::App* add_render(CLI::App& program, RenderOptions& options) {
  CLI::App* render =
      program.add_subcommand("render", "Draw a scene of moving objects, to PNG or animated PNG");
  add_picture_options(*render, options);
  add_drawing_options(*render, options);
  render->add_flag("--explain", options.explain,
                   "Print what each textured face of the first frame is drawn by, and why");
  render->add_flag("--stats", options.stats, "Print how much was drawn, and how fast");
  render->add_flag("--json", options.json, "Print what these two tell as JSON");
  render->footer(kRenderText);
  return render;
}

}  // namespace selvage::cli
