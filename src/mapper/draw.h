// The pipeline: polygon -> edges -> spans -> texels -> pixels.
#pragma once

#include "mapper/polygon.h"
#include "selvage.h"

namespace selvage::mapper {

// All arguments have passed their checks; `visible` lies within the target or is empty.
void draw(const selvage_image& target, const selvage_rect& visible, const Polygon& polygon,
          const selvage_texture& texture, selvage_address address, selvage_filter filter);

}  // namespace selvage::mapper
