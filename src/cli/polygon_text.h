// The command line's forms for geometry.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "cli/job.h"
#include "cli/raster.h"

namespace selvage::cli {

// "x,y,u,v[,w] x,y,u,v[,w] ...": vertices apart by blanks, px and texels; at least three.
[[nodiscard]] std::vector<JobVertex> parse_polygon_text(std::string_view text);

// "left,top,right,bottom": whole pixels, half-open.
[[nodiscard]] selvage_rect parse_clip_text(std::string_view text);

struct Size {
  int32_t width_px = 0, height_px = 0;
};
// "256x192", within SizeLimits.
[[nodiscard]] Size parse_size_text(std::string_view text, const SizeLimits& limits = {});

}  // namespace selvage::cli
