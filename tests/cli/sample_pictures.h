// Pictures and picture files to test with, each made from scratch.
#pragma once

#include <cstdint>
#include <vector>

#include "cli/raster.h"

namespace selvage::cli::test {

// Every pixel differs from its neighbours; alpha varies unless `opaque`.
[[nodiscard]] Raster sample_raster(int32_t width_px, int32_t height_px, bool opaque = false);

// Smooth, so that lossy compression stays close.
[[nodiscard]] Raster smooth_raster(int32_t width_px, int32_t height_px);

struct PngKind {
  int colour_type;  // PNG_COLOR_TYPE_*
  int bit_depth;
  bool interlaced;
};
// A 9 x 7 picture of that kind, through libpng's full interface.
[[nodiscard]] std::vector<uint8_t> sample_png(const PngKind& kind);

// The same file with another size in its header, the checksum made right again.
[[nodiscard]] std::vector<uint8_t> with_png_size(std::vector<uint8_t> png, uint32_t width_px,
                                                 uint32_t height_px);

enum class JpegKind { kColour, kGrey, kProgressive, kCmyk };
[[nodiscard]] std::vector<uint8_t> encode_jpeg(const Raster& raster, JpegKind kind);

// The same file with another size in its frame header.
[[nodiscard]] std::vector<uint8_t> with_jpeg_size(std::vector<uint8_t> jpeg, uint16_t width_px,
                                                  uint16_t height_px);

}  // namespace selvage::cli::test
