// The pipeline: polygon -> edges -> spans -> texels -> pixels.
#pragma once

#include "mapper/kernel.h"
#include "mapper/polygon.h"
#include "selvage.h"

namespace selvage::mapper {

// All arguments have passed their checks; `visible` lies within the target or is empty. The kernels
// are those that are chosen for the polygon.
void draw(const Surface& surface, const selvage_rect& visible, const Polygon& polygon,
          const selvage_options& options, const Kernels& kernels);

// What draw() draws by.
[[nodiscard]] selvage_choice choose(const Surface& surface, const selvage_rect& visible,
                                    const Polygon& polygon, const selvage_options& options);

}  // namespace selvage::mapper
