// PNG from and to memory. Source of the format: ISO/IEC 15948.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "cli/raster.h"

namespace selvage::cli {

[[nodiscard]] bool is_png(std::span<const uint8_t> bytes);

// Every kind of PNG as 8-bit sRGB with alpha. A UserError says what is wrong: cut short, damaged,
// or larger than the limits.
[[nodiscard]] Raster decode_png(std::span<const uint8_t> bytes, const SizeLimits& limits = {});

[[nodiscard]] std::vector<uint8_t> encode_png(const Raster& raster);

}  // namespace selvage::cli
