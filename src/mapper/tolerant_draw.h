// Drawing in perspective, and telling what it is drawn by, where texels need not be exact.
#pragma once

#include "mapper/kernel.h"
#include "mapper/polygon.h"
#include "mapper/tolerance.h"
#include "selvage.h"

namespace selvage::mapper {

// Nearest texels in a part_of() the polygon that is not empty; tolerance_fx16 > 0. Rows for which
// nothing else is within it are exact.
void draw_tolerantly(const Surface& surface, const selvage_rect& part, const Polygon& polygon,
                     const Kernels& kernels, int32_t tolerance_fx16);

// Over all rows of a part_of() the polygon: the method that costs most, the shortest segment, the
// greatest bound.
[[nodiscard]] RowChoice choose_tolerantly(const selvage_rect& part, const Polygon& polygon,
                                          int32_t tolerance_fx16,
                                          const Stepping& stepping = kUsualStepping);

}  // namespace selvage::mapper
