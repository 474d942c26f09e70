// The two-stage DDA texture mapper of Abrash, "Pooh and the Space Station" (Dr. Dobb's Journal,
// September 1992; Graphics Programming Black Book, chapter 56), and its sequel (chapter 57): edges
// are stepped through source and target alike, then the span between them is.
//
// Hardened: coordinates are carried in 64 bits, texels are addressed, rows above the clip are
// jumped over. Nothing that the published arithmetic defines is changed by that.
#pragma once

#include "historic/edge_scan.h"
#include "mapper/polygon.h"
#include "selvage.h"

namespace selvage::historic {

// The polygon has passed check_whole_px; `visible` lies within the target or is empty.
// Prestep::kNone is abrash56, whose texels are floor(u); kHalf is abrash57, floor(u + 1/2).
void draw_two_stage(const selvage_image& target, const selvage_rect& visible,
                    const mapper::Polygon& polygon, const selvage_texture& texture,
                    selvage_address address, Prestep prestep);

}  // namespace selvage::historic
