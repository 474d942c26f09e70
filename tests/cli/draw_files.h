// `selvage draw` of one polygon, for tests that change what it is asked for.
#pragma once

#include <gtest/gtest.h>

#include <sstream>
#include <string>
#include <vector>

#include "cli/draw_command.h"
#include "cli/png.h"
#include "sample_pictures.h"
#include "support.h"

namespace selvage::cli::test {

inline constexpr const char* kQuad = "10,10,0,0 100,12.25,24,0 90,70,24,18 4,60,0,18";

class Draw : public InDirectory {
 protected:
  Draw() {
    put("texture.png", encode_png(texture_));
    options_.texture = "texture.png";
    options_.polygons = {kQuad};
    options_.size = "120x80";
    options_.background = "#203040";
    options_.output = "out.png";
  }

  int run() {
    err_.str("");
    return run_draw(options_, {out_, err_});
  }
  // Runs, which must fail, and leave nothing but what was there.
  std::string refusal() {
    const std::vector<std::string> before = files();
    const std::string error = error_of([&] { run(); });
    EXPECT_EQ(files(), before);
    return error;
  }
  [[nodiscard]] static Raster output() { return decode_picture_file("out.png"); }
  [[nodiscard]] static Raster decode_picture_file(const std::string& name) {
    const std::string bytes = get(name);
    return decode_png(std::span(reinterpret_cast<const uint8_t*>(bytes.data()), bytes.size()));
  }

  const Raster texture_ = sample_raster(24, 18);
  DrawOptions options_;
  std::ostringstream out_, err_;
};

}  // namespace selvage::cli::test
