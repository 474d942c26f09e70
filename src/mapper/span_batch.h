// Spans of consecutive rows, without what their edges carry.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

#include "mapper/edge.h"
#include "mapper/polygon.h"
#include "mapper/span.h"

namespace selvage::mapper {

inline constexpr int32_t kRowsPerBatch = 64;

struct SpanBatch {
  int32_t first_row, rows;
  int32_t widest_px;
  std::array<int32_t, kRowsPerBatch> left_px, right_px;  // of an empty span, both the same

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

// All rows of a polygon that are visible, a batch at a time.
class BatchWalk {
 public:
  BatchWalk(const Polygon& polygon, const selvage_rect& visible)
      : visible_(visible),
        row_(std::max(polygon.top_row, visible.top)),
        end_row_(std::min(polygon.bottom_row, visible.bottom)),
        forward_(polygon, Chain::Direction::kForward),
        backward_(polygon, Chain::Direction::kBackward) {}

  // False where no row is left.
  [[nodiscard]] bool next(SpanBatch* batch) {
    if (row_ >= end_row_) return false;
    batch->first_row = row_;
    batch->rows = std::min(end_row_ - row_, kRowsPerBatch);
    row_ += batch->rows;
    forward_.columns(batch->first_row, row_, batch->left_px.data());
    backward_.columns(batch->first_row, row_, batch->right_px.data());
    clip(batch);
    return true;
  }

 private:
  // Which chain is left is decided row by row.
  void clip(SpanBatch* batch) const {
    batch->widest_px = 0;
    for (size_t i = 0; i < static_cast<size_t>(batch->rows); ++i) {
      const int32_t a = batch->left_px[i], b = batch->right_px[i];
      const int32_t left = std::max(std::min(a, b), visible_.left);
      const int32_t right = std::max(std::min(std::max(a, b), visible_.right), left);
      batch->left_px[i] = left;
      batch->right_px[i] = right;
      batch->widest_px = std::max(batch->widest_px, right - left);
    }
  }

  selvage_rect visible_;
  int32_t row_, end_row_;
  Chain forward_, backward_;
};

}  // namespace selvage::mapper
