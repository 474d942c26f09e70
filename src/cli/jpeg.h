// JPEG from memory.
#pragma once

#include <cstdint>
#include <span>

#include "cli/raster.h"

namespace selvage::cli {

[[nodiscard]] bool is_jpeg(std::span<const uint8_t> bytes);

// Grey and colour JPEGs, baseline and progressive. A UserError says what is wrong: cut short,
// damaged, CMYK, or larger than the limits.
[[nodiscard]] Raster decode_jpeg(std::span<const uint8_t> bytes, const SizeLimits& limits = {});

}  // namespace selvage::cli
