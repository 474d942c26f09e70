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

// Whether as many texel centres as there are pixels lie along both sides of an axis-aligned
// rectangle that runs clockwise: columns [left, right) with u from left + ds to right - 1 + ds,
// rows likewise. Of width W it has W - 1 steps over W pixels, which a 16.16 DDA cannot always keep
// apart.
[[nodiscard]] std::optional<BlockShift> block_shift(const mapper::Polygon& polygon);

}  // namespace selvage::historic
