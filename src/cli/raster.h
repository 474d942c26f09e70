// Pictures as the program holds them: owned pixels, top row first, no padding.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "selvage.h"

namespace selvage::cli {

struct Colour {
  uint8_t red = 0, green = 0, blue = 0, alpha = 255;
  friend bool operator==(const Colour&, const Colour&) = default;
};

// "#rgb", "#rrggbb" or "#rrggbbaa".
[[nodiscard]] Colour parse_colour(std::string_view text);

// The largest picture that is read or drawn. What a header claims is held against it before
// anything of that size is allocated: at most 256 MiB of RGBA.
struct SizeLimits {
  int32_t side_px = 32768;
  int64_t area_px = int64_t{1} << 26;
};

// Throws a UserError unless 1 <= width, height <= side and width x height <= area.
void check_size(int64_t width_px, int64_t height_px, const SizeLimits& limits = {});

// Red, green, blue, alpha: one byte each.
struct Raster {
  int32_t width_px = 0, height_px = 0;
  std::vector<uint8_t> rgba;

  [[nodiscard]] Colour at(int32_t x_px, int32_t y_px) const;
  void set(int32_t x_px, int32_t y_px, const Colour& colour);
  friend bool operator==(const Raster&, const Raster&) = default;

 private:
  [[nodiscard]] size_t offset(int32_t x_px, int32_t y_px) const;
};

[[nodiscard]] Raster filled(int32_t width_px, int32_t height_px, const Colour& colour);

}  // namespace selvage::cli
