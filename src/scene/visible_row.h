// What shows of the faces on one scan line.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "scene/row_span.h"

namespace selvage::scene {

// Columns [first_px, end_px), where span number `span` shows.
struct Segment {
  int32_t first_px, end_px;
  size_t span;
};

// Disjoint segments from left to right, which cover what the spans cover.
//
// On a row q is linear along each span, so where two overlap the nearer one changes at most once:
// if it is the same at both ends it is the same between, otherwise the faces cut through each other
// and halving finds the column.
class VisibleRow {
 public:
  // The spans are not empty. Their order does not matter but for equal q. The result is good until
  // the next call.
  [[nodiscard]] std::span<const Segment> resolve(std::span<const RowSpan> spans);

 private:
  void add(std::span<const RowSpan> spans, size_t newcomer);
  void contest(std::span<const RowSpan> spans, const Segment& overlap, size_t newcomer);
  void put(int32_t first_px, int32_t end_px, size_t span);

  std::vector<Segment> row_, next_;
};

}  // namespace selvage::scene
