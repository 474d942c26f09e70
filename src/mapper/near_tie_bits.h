// How many bits tell on which side of a whole number near-ties of n / d lie: the sign of n - k d.
#pragma once

#include <algorithm>
#include <cstdint>

#include "mapper/exact_row.h"
#include "mapper/number.h"
#include "mapper/span_batch.h"

namespace selvage::mapper {

// Columns [left_px, right_px): all that spans of a batch have, and at least one.
struct BatchColumns {
  int32_t left_px, right_px;

  [[nodiscard]] static BatchColumns of(const SpanBatch& batch) {
    BatchColumns columns{batch.left_px[0], batch.left_px[0] + 1};
    for (int32_t i = 0; i < batch.rows; ++i) {
      const Span span = batch.span(i);
      columns.left_px = std::min(columns.left_px, span.left_px);
      columns.right_px = std::max(columns.right_px, span.right_px);
    }
    return columns;
  }
};

// The most that a line is in the box of a batch's pixels, at one of its corners. The line is that
// of the first row from its first pixel on, and rises by `down` from row to row.
[[nodiscard]] inline int128 most_in_box(const ExactLine& line, uint128 down,
                                        const SpanBatch& batch) {
  const auto [left_px, right_px] = BatchColumns::of(batch);
  const auto times = [](int32_t steps, uint128 by) {
    return static_cast<int128>(static_cast<uint128>(int128{steps}) * by);
  };
  const int32_t first_px = batch.left_px[0];
  const int128 right =
      std::max(times(left_px - first_px, line.step), times(right_px - 1 - first_px, line.step));
  return static_cast<int128>(line.start) + right + std::max(times(batch.rows - 1, down), int128{0});
}

// Whether 64 do, by the most that d is. Near-ties are no further from the whole number than
// 2^-spare_bits, so that |n - k d| <= d / 2^spare_bits; a bit is the sign's, and one is spare.
[[nodiscard]] inline bool are_64_enough(int128 most_d, int spare_bits) {
  return most_d >> spare_bits < int128{1} << 62;
}

}  // namespace selvage::mapper
