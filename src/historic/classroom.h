// The scan-line texture mapper as it is taught (O'Reilly's notes, Dundalk Institute of Technology):
// on each scan line the two edges and the texture's coordinates on them are rounded, and between
// them, both ends included, the texture is walked in E2 - E1 equal steps and rounded again.
#pragma once

#include "mapper/polygon.h"
#include "selvage.h"

namespace selvage::historic {

// The polygon has passed check_whole_px; `visible` lies within the target or is empty.
void draw_classroom(const selvage_image& target, const selvage_rect& visible,
                    const mapper::Polygon& polygon, const selvage_texture& texture,
                    selvage_address address);

}  // namespace selvage::historic
