// Spans of consecutive rows, without what their edges carry.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

#include "mapper/outline.h"
#include "mapper/polygon.h"
#include "mapper/span.h"

namespace selvage::mapper {

inline constexpr int32_t kRowsPerBatch = 64;
inline constexpr int32_t kMostDoubles = 8;  // in a vector
inline constexpr int32_t kMostLanes = 16;   // of 32 bits

struct SpanBatch {
  int32_t first_row, rows;
  int32_t widest_px;
  // Of an empty span, both the same. With room for a vector that begins in the last row.
  std::array<int32_t, kRowsPerBatch + kMostLanes> left_px, right_px;

  [[nodiscard]] Span span(int32_t index) const {
    const auto i = static_cast<size_t>(index);
    return {first_row + index, left_px[i], right_px[i]};
  }
};

[[nodiscard]] inline SpanBatch one_span(const Span& span) {
  SpanBatch batch;
  batch.first_row = span.row;
  batch.rows = 1;
  batch.widest_px = span.width_px();
  batch.left_px[0] = span.left_px;
  batch.right_px[0] = span.right_px;
  return batch;
}

// From edges to the spans of a batch's rows within these columns, and to the widest of them. Rows
// rise from call to call.
using FindSpans = void (*)(Outline* outline, int32_t left_px, int32_t right_px, SpanBatch* batch);

void find_spans_scalar(Outline* outline, int32_t left_px, int32_t right_px, SpanBatch* batch);

// All rows of a part_of() a polygon, a batch at a time.
class BatchWalk {
 public:
  BatchWalk(const Polygon& polygon, const selvage_rect& part, FindSpans find_spans)
      : find_spans_(find_spans),
        left_px_(part.left),
        right_px_(part.right),
        row_(part.top),
        end_row_(part.bottom),
        outline_(polygon) {}

  // False where no row is left.
  [[nodiscard]] bool next(SpanBatch* batch) {
    if (row_ >= end_row_) return false;
    batch->first_row = row_;
    batch->rows = std::min(end_row_ - row_, kRowsPerBatch);
    row_ += batch->rows;
    find_spans_(&outline_, left_px_, right_px_, batch);
    return true;
  }

 private:
  FindSpans find_spans_;
  int32_t left_px_, right_px_, row_, end_row_;
  Outline outline_;
};

}  // namespace selvage::mapper
