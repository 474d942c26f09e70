// The walk down a polygon: its edges on each visible scan line, and the span between them.
#pragma once

#include <algorithm>

#include "mapper/edge.h"
#include "mapper/polygon.h"
#include "mapper/span.h"

namespace selvage::mapper {

class SpanWalk {
 public:
  SpanWalk(const Polygon& polygon, const selvage_rect& visible)
      : visible_(visible),
        row_(std::max(polygon.top_row, visible.top) - 1),
        end_row_(std::min(polygon.bottom_row, visible.bottom)),
        forward_(polygon, Chain::Direction::kForward),
        backward_(polygon, Chain::Direction::kBackward) {}

  // Goes down to the next span that is not empty; false where there is none.
  [[nodiscard]] bool next() { return next_above(end_row_); }
  // The same, but stays above a row of the walk.
  [[nodiscard]] bool next_above(int32_t end_row) {
    while (row_ + 1 < end_row) {
      ++row_;
      const Edge& a = forward_.at_row(row_);
      const Edge& b = backward_.at_row(row_);
      const bool a_is_left = a.first_px() <= b.first_px();
      left_ = a_is_left ? &a : &b;
      right_ = a_is_left ? &b : &a;
      span_ = Span{.row = row_,
                   .left_px = std::max(left_->first_px(), visible_.left),
                   .right_px = std::min(right_->first_px(), visible_.right)};
      if (!span_.empty()) return true;
    }
    return false;
  }

  // Leaves out all rows above one that lies further down.
  void skip_to(int32_t row) { row_ = row - 1; }

  [[nodiscard]] const Span& span() const { return span_; }
  // The same row, clipped by nothing.
  [[nodiscard]] Span whole_span() const {
    return {span_.row, left_->first_px(), right_->first_px()};
  }
  [[nodiscard]] SpanMap map() const { return {left_->at(row_), right_->at(row_)}; }
  [[nodiscard]] const Edge& left() const { return *left_; }
  [[nodiscard]] const Edge& right() const { return *right_; }

 private:
  selvage_rect visible_;
  int32_t row_, end_row_;
  Chain forward_, backward_;
  const Edge* left_ = nullptr;
  const Edge* right_ = nullptr;
  Span span_;
};

}  // namespace selvage::mapper
