#include "mapper/near_tie_bits.h"

#include <algorithm>
#include <cstdint>

namespace selvage::mapper {
namespace {

// [left_px, right_px): all that spans of a batch have, and at least one.
struct Columns {
  int32_t left_px, right_px;

  explicit Columns(const SpanBatch& batch)
      : left_px(batch.left_px[0]), right_px(batch.left_px[0] + 1) {
    for (int32_t i = 0; i < batch.rows; ++i) {
      const Span span = batch.span(i);
      left_px = std::min(left_px, span.left_px);
      right_px = std::max(right_px, span.right_px);
    }
  }
};

[[nodiscard]] int128 times(int32_t steps, uint128 by) {
  return static_cast<int128>(static_cast<uint128>(int128{steps}) * by);
}

}  // namespace

// A linear function's most in a box is at one of the corners.
int128 most_in_box(const ExactLine& line, uint128 down, const SpanBatch& batch) {
  const Columns columns(batch);
  const int32_t first_px = batch.left_px[0];
  const int128 right = std::max(times(columns.left_px - first_px, line.step),
                                times(columns.right_px - 1 - first_px, line.step));
  return static_cast<int128>(line.start) + right + std::max(times(batch.rows - 1, down), int128{0});
}

}  // namespace selvage::mapper
