#include "cli/bitmap.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <string>
#include <utility>

#include "cli/error.h"

namespace selvage::cli {
namespace {

struct NamedFormat {
  std::string_view name;
  selvage_format format;
  size_t bytes_per_pixel;
};

constexpr std::array<NamedFormat, 3> kFormats{{{"rgba8888", SELVAGE_RGBA8888, 4},
                                               {"rgb565", SELVAGE_RGB565, 2},
                                               {"index8", SELVAGE_INDEX8, 1}}};

[[nodiscard]] const NamedFormat& find(selvage_format format) {
  return *std::find_if(kFormats.begin(), kFormats.end(),
                       [&](const NamedFormat& known) { return known.format == format; });
}

// The nearest of levels 0 .. to for level `value` of 0 .. from.
[[nodiscard]] uint32_t rescale(uint32_t value, uint32_t from, uint32_t to) {
  return (2 * value * to + from) / (2 * from);
}

[[nodiscard]] uint16_t to_rgb565(const uint8_t* rgba) {
  return static_cast<uint16_t>(rescale(rgba[0], 255, 31) << 11 | rescale(rgba[1], 255, 63) << 5 |
                               rescale(rgba[2], 255, 31));
}

void from_rgb565(uint16_t pixel, uint8_t* rgba) {
  rgba[0] = static_cast<uint8_t>(rescale(pixel >> 11, 31, 255));
  rgba[1] = static_cast<uint8_t>(rescale(pixel >> 5 & 63, 63, 255));
  rgba[2] = static_cast<uint8_t>(rescale(pixel & 31, 31, 255));
  rgba[3] = 255;
}

[[nodiscard]] uint8_t to_grey(const uint8_t* rgba) {
  return static_cast<uint8_t>((77 * rgba[0] + 150 * rgba[1] + 29 * rgba[2] + 128) >> 8);
}

}  // namespace

ptrdiff_t Bitmap::pitch() const {
  return static_cast<ptrdiff_t>(width_px) * static_cast<ptrdiff_t>(find(format).bytes_per_pixel);
}

selvage_image Bitmap::image() { return {bytes.data(), width_px, height_px, pitch(), format}; }

selvage_texture Bitmap::texture() const {
  return {bytes.data(), width_px, height_px, pitch(), format, SELVAGE_LAYOUT_ROWS, nullptr};
}

selvage_format parse_format(std::string_view name) {
  for (const NamedFormat& known : kFormats) {
    if (known.name == name) return known.format;
  }
  if (name == "grey8") return SELVAGE_INDEX8;
  throw UserError("'" + std::string(name) + "' is no format; rgba8888, rgb565 and index8 are");
}

std::string_view format_name(selvage_format format) { return find(format).name; }

Bitmap to_bitmap(Raster raster, selvage_format format) {
  Bitmap bitmap{format, raster.width_px, raster.height_px, {}};
  if (format == SELVAGE_RGBA8888) {
    bitmap.bytes = std::move(raster.rgba);
    return bitmap;
  }
  const size_t count = raster.rgba.size() / 4;
  bitmap.bytes.resize(count * find(format).bytes_per_pixel);
  for (size_t i = 0; i < count; ++i) {
    const uint8_t* pixel = raster.rgba.data() + 4 * i;
    if (format == SELVAGE_RGB565) {
      const uint16_t packed = to_rgb565(pixel);
      std::memcpy(bitmap.bytes.data() + 2 * i, &packed, 2);
    } else {
      bitmap.bytes[i] = to_grey(pixel);
    }
  }
  return bitmap;
}

Raster to_raster(Bitmap bitmap) {
  Raster raster{bitmap.width_px, bitmap.height_px, {}};
  if (bitmap.format == SELVAGE_RGBA8888) {
    raster.rgba = std::move(bitmap.bytes);
    return raster;
  }
  const size_t count = bitmap.bytes.size() / find(bitmap.format).bytes_per_pixel;
  raster.rgba.resize(4 * count);
  for (size_t i = 0; i < count; ++i) {
    uint8_t* pixel = raster.rgba.data() + 4 * i;
    if (bitmap.format == SELVAGE_RGB565) {
      uint16_t packed = 0;
      std::memcpy(&packed, bitmap.bytes.data() + 2 * i, 2);
      from_rgb565(packed, pixel);
    } else {
      std::fill_n(pixel, 3, bitmap.bytes[i]);
      pixel[3] = 255;
    }
  }
  return raster;
}

}  // namespace selvage::cli
