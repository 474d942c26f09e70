// Drawing with the area filter: polygon -> spans -> points and footprints -> boxes -> pixels.
#pragma once

#include "mapper/kernel.h"
#include "mapper/polygon.h"
#include "selvage.h"

namespace selvage::mapper {

// As draw(), for RGBA8888 images and by the area filter's kernels; something is visible.
void draw_area(const Surface& surface, const selvage_rect& visible, const Polygon& polygon,
               const Kernels& kernels);

}  // namespace selvage::mapper
