// A picture in one of the formats that the mapper draws in.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "cli/raster.h"
#include "selvage.h"

namespace selvage::cli {

struct Bitmap {
  selvage_format format = SELVAGE_RGBA8888;
  int32_t width_px = 0, height_px = 0;
  std::vector<uint8_t> bytes;  // rows without padding

  [[nodiscard]] selvage_image image();
  [[nodiscard]] selvage_texture texture() const;

 private:
  [[nodiscard]] ptrdiff_t pitch() const;
};

// "rgba8888", "rgb565", or "index8", of which "grey8" is another name.
[[nodiscard]] selvage_format parse_format(std::string_view name);
[[nodiscard]] std::string_view format_name(selvage_format format);

// Channels are rounded to the nearest level. SELVAGE_INDEX8 holds levels of grey. Grey is (77 red +
// 150 green + 29 blue + 128) >> 8, the luma weights of ITU-R BT.601. Only RGBA8888 keeps alpha; the
// others come back opaque.
[[nodiscard]] Bitmap to_bitmap(Raster raster, selvage_format format);
[[nodiscard]] Raster to_raster(Bitmap bitmap);

}  // namespace selvage::cli
