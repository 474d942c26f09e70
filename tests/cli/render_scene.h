// `selvage render` of a small scene, for tests that change it.
#pragma once

#include <algorithm>
#include <sstream>
#include <string>

#include "cli/png.h"
#include "cli/render_command.h"
#include "support.h"

namespace selvage::cli::test {

// A square of 2 by 2 in front of the camera, of one colour as it is.
inline constexpr const char* kSquare =
    "mtllib square.mtl\nv -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nusemtl red\nf 1 2 3 4\n";
inline constexpr const char* kSquareScene =
    R"({"camera": {"position": [0, 0, 4], "view_deg": 53.13010235415598},
        "background": "#000040", "objects": [{"file": "square.obj", "velocity": [1, 0, 0]}]})";

class Render : public InDirectory {
 protected:
  Render() {
    put("square.obj", std::string(kSquare));
    put("square.mtl", std::string("newmtl red\nKd 1 0 0\nillum 0\n"));
    put("scene.json", std::string(kSquareScene));
    options_.scene = "scene.json";
    options_.output = "out.png";
    options_.size = "80x60";
  }

  int run() {
    err_.str("");
    return run_render(options_, {out_, err_});
  }
  [[nodiscard]] static Raster picture(const std::string& name) {
    const std::string bytes = get(name);
    return decode_png(std::span(reinterpret_cast<const uint8_t*>(bytes.data()), bytes.size()));
  }
  [[nodiscard]] static int red_pixels(const Raster& raster) {
    int count = 0;
    for (int32_t y = 0; y < raster.height_px; ++y) {
      for (int32_t x = 0; x < raster.width_px; ++x)
        count += raster.at(x, y) == Colour{255, 0, 0, 255};
    }
    return count;
  }

  RenderOptions options_;
  std::ostringstream out_, err_;
};

}  // namespace selvage::cli::test
