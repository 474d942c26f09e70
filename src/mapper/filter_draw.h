// Drawing with a filter other than nearest: polygon -> spans -> points -> mixed texels -> pixels.
#pragma once

#include "mapper/kernel.h"
#include "mapper/polygon.h"
#include "selvage.h"

namespace selvage::mapper {

// As draw(), for RGBA8888 images and a filter other than nearest; something is visible.
void draw_filtered(const Surface& surface, const selvage_rect& visible, const Polygon& polygon,
                   selvage_filter filter);

}  // namespace selvage::mapper
