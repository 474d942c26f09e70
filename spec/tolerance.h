// Tolerance: how far a row drawn by straight segments may be from its map (spec/README.md, 8.9).
#pragma once

#include <cstdint>

#include "spec/exact.h"

namespace selvage::spec {

// The columns [first, end) whose centres a scan line covers.
struct Columns {
  int32_t first_px, end_px;

  [[nodiscard]] bool empty() const { return first_px >= end_px; }
  [[nodiscard]] int32_t last_px() const { return end_px - 1; }
};
[[nodiscard]] Columns columns_of(const ScanLine& line);

// The greatest distance in u and in v, in texels, of the map at the line's pixels from straight
// segments between its values segment_px apart, or at the row's ends if that is nearer or
// segment_px is 0: |(uq)' q - uq q'| |q'| N^2 / (4 q_min^3). The line covers a pixel.
[[nodiscard]] Rational chord_bound(const ScanLine& line, int32_t segment_px);

// What 16.16 lanes may be off besides, in 1/65536 texel: 4 + (2 max(r, 4096) + 4 + 2 n) / 65536,
// for r the ratio of the greatest q to the least and n the steps from the first pixel to the last.
[[nodiscard]] Rational rounding_bound_fx16(const ScanLine& line);

}  // namespace selvage::spec
