// Drawing with a filter other than nearest: polygon -> spans -> points -> mixed texels -> pixels.
#pragma once

#include "mapper/polygon.h"
#include "selvage.h"

namespace selvage::mapper {

// As draw(), for RGBA8888 images and a filter other than nearest.
void draw_filtered(const selvage_image& target, const selvage_rect& visible, const Polygon& polygon,
                   const selvage_texture& texture, selvage_address address, selvage_filter filter);

}  // namespace selvage::mapper
