// The pictures that the gallery draws with: files of the package xplanet-images, and plain ones.
#pragma once

#include <filesystem>

#include "cli/raster.h"

namespace selvage::reports {

struct Pictures {
  cli::Raster earth;                 // a map, 2048 x 1024 texels
  cli::Raster iss, hubble, shuttle;  // spacecraft, below 100 texels a side
  cli::Raster checker;               // 8 x 8 texels, two colours
  cli::Raster grid_line;             // one texel
};

// A UserError names a file that is missing or unreadable.
[[nodiscard]] Pictures load_pictures(const std::filesystem::path& directory);

// Half the size: each texel the rounded mean of 2 x 2.
[[nodiscard]] cli::Raster halved(const cli::Raster& picture);

}  // namespace selvage::reports
