#include "cli/raster.h"

#include <charconv>

#include "cli/error.h"

namespace selvage::cli {

Colour parse_colour(std::string_view text) {
  const auto wrong = [&] {
    return UserError("'" + std::string(text) + "' is no colour; #rgb, #rrggbb or #rrggbbaa is");
  };
  if (text.empty() || text.front() != '#') throw wrong();
  const std::string_view digits = text.substr(1);
  if (digits.find_first_not_of("0123456789abcdefABCDEF") != std::string_view::npos) throw wrong();
  const auto channel = [&](size_t at, size_t length) {
    uint8_t value = 0;
    std::from_chars(digits.data() + at, digits.data() + at + length, value, 16);
    return length == 1 ? static_cast<uint8_t>(value * 17) : value;
  };
  switch (digits.size()) {
    case 3:
      return {channel(0, 1), channel(1, 1), channel(2, 1)};
    case 6:
      return {channel(0, 2), channel(2, 2), channel(4, 2)};
    case 8:
      return {channel(0, 2), channel(2, 2), channel(4, 2), channel(6, 2)};
    default:
      throw wrong();
  }
}

void check_size(int64_t width_px, int64_t height_px, const SizeLimits& limits) {
  const bool sides_fit =
      width_px >= 1 && height_px >= 1 && width_px <= limits.side_px && height_px <= limits.side_px;
  if (sides_fit && width_px * height_px <= limits.area_px) return;
  throw UserError("a picture of " + std::to_string(width_px) + " x " + std::to_string(height_px) +
                  " px is not accepted; 1 to " + std::to_string(limits.side_px) +
                  " px a side and at most " + std::to_string(limits.area_px) + " px in all are");
}

size_t Raster::offset(int32_t x_px, int32_t y_px) const {
  return 4 *
         (static_cast<size_t>(y_px) * static_cast<size_t>(width_px) + static_cast<size_t>(x_px));
}

Colour Raster::at(int32_t x_px, int32_t y_px) const {
  const uint8_t* pixel = rgba.data() + offset(x_px, y_px);
  return {pixel[0], pixel[1], pixel[2], pixel[3]};
}

void Raster::set(int32_t x_px, int32_t y_px, const Colour& colour) {
  uint8_t* pixel = rgba.data() + offset(x_px, y_px);
  pixel[0] = colour.red;
  pixel[1] = colour.green;
  pixel[2] = colour.blue;
  pixel[3] = colour.alpha;
}

Raster filled(int32_t width_px, int32_t height_px, const Colour& colour) {
  Raster raster{width_px, height_px, {}};
  const size_t count = static_cast<size_t>(width_px) * static_cast<size_t>(height_px);
  raster.rgba.resize(4 * count);
  for (size_t i = 0; i < count; ++i) {
    raster.rgba[4 * i] = colour.red;
    raster.rgba[4 * i + 1] = colour.green;
    raster.rgba[4 * i + 2] = colour.blue;
    raster.rgba[4 * i + 3] = colour.alpha;
  }
  return raster;
}

}  // namespace selvage::cli
