// A picture from bytes or from a file, whichever of the known kinds it is.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>

#include "cli/raster.h"

namespace selvage::cli {

[[nodiscard]] Raster decode_picture(std::span<const uint8_t> bytes, const SizeLimits& limits = {});

// Errors name the file.
[[nodiscard]] Raster read_picture(const std::filesystem::path& path);

}  // namespace selvage::cli
