// Drawing with the area filter: polygon -> spans -> points and footprints -> boxes -> pixels.
#pragma once

#include "mapper/kernel.h"
#include "mapper/polygon.h"
#include "selvage.h"

namespace selvage::mapper {

// As draw(), for RGBA8888 images and by the area filter's kernels, a part_of() the polygon that is
// not empty.
void draw_area(const Surface& surface, const selvage_rect& part, const Polygon& polygon,
               const Kernels& kernels);

}  // namespace selvage::mapper
