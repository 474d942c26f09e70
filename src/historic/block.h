// The untransformed rectangle of a mapper whose texel centres lie at whole u.
#pragma once

#include <cstdint>
#include <optional>

#include "mapper/polygon.h"

namespace selvage::historic {

// Pixel (i, j) shows texel (i + ds, j + dt).
struct BlockShift {
  int32_t ds, dt;
};

// Whether the outline is a clockwise rectangle, columns [left, right) and rows [top, bottom), along
// whose sides as many texel centres lie as there are pixels: u = left + ds on its left side and
// right - 1 + ds on its right one, v from top + dt to bottom - 1 + dt down both. Of width W it has
// W - 1 steps over W pixels, which a 16.16 DDA cannot always keep apart.
[[nodiscard]] std::optional<BlockShift> block_shift(const mapper::Polygon& polygon);

}  // namespace selvage::historic
