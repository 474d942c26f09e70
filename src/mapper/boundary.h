// The line between two texels: on which side of it pixels lie.
#pragma once

#include <cstdint>

#include "mapper/exact_row.h"
#include "mapper/span.h"

namespace selvage::mapper {

// Where a coordinate n / d is a whole number k. As d > 0 at all pixels, they are at the line or
// beyond it where n - k d >= 0. That is linear, so that what holds for two pixels of a row holds
// for those between them, and it changes its sign once.
//
// It is evaluated in double: three numbers converted, two products, two sums and one product more
// are off by less than 5 * 2^-53 of the sum of their magnitudes, which is less than kDoubt of it
// as that is rounded. Where all three numbers are 0, so is the difference, and it is told exactly.
class Boundary {
 public:
  Boundary() = default;
  // Of u or v in units of 2^-bits texel, by a pixel of the map and the one below it.
  Boundary(const ExactMap& map, ExactLine ExactRow::*coordinate, int bits, int32_t whole,
           int32_t px, int32_t row);

  // Of some pixels of a row, how many at its left are on one side, all others being on the other
  // one; -1 where that is not certain.
  struct Sides {
    int32_t left_px;
    bool left_beyond;
  };
  [[nodiscard]] Sides sides_of(const Span& pixels) const;

 private:
  int32_t px_ = 0, row_ = 0;
  double start_ = 0, right_ = 0, down_ = 0;
};

}  // namespace selvage::mapper
