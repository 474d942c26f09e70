// How many bits tell on which side of a whole number near-ties of n / d lie: the sign of n - k d.
#pragma once

#include <cmath>

#include "mapper/exact_row.h"
#include "mapper/number.h"
#include "mapper/span_batch.h"

namespace selvage::mapper {

// The most that a line is in the box of a batch's pixels. The line is that of the first row from
// its first pixel on, and rises by `down` from row to row.
[[nodiscard]] int128 most_in_box(const ExactLine& line, uint128 down, const SpanBatch& batch);

// Whether so many bits tell, by the most that d is, but for some roundings of it. Near-ties are no
// further from the whole number than 2^-spare_bits, so that |n - k d| <= d / 2^spare_bits; a bit is
// the sign's, and one is spare.
[[nodiscard]] inline bool are_enough(int bits, double most_d, int spare_bits) {
  return most_d < std::ldexp(1.0, bits - 2 + spare_bits);
}

}  // namespace selvage::mapper
