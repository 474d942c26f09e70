// The pixels of a y-monotone polygon as spans: the half-open rule with pixel centres at +1/2, by an
// exact integer edge walk. What the subdivided loop and the fill draw, and the count of covered
// pixels.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "reports/bench/workloads.h"
#include "selvage.h"
#include "spec/vertex_units.h"

namespace selvage::reports {

inline constexpr size_t kMaxPolygonVertices = 8;  // what the workloads need

struct Span {
  int32_t y_px, left_px, right_px;  // columns [left, right)
};

// The first row whose centre is at or below y, which is in its range.
[[nodiscard]] constexpr int32_t row_at_or_below(int32_t y_fx8) {
  static_assert(spec::kPixel_fx8 == 1 << 8);
  return (y_fx8 + spec::kHalfPixel_fx8 - 1) >> 8;
}

// An edge as the first covered column of each of its rows: ceil of its x at the row's centre,
// less 1/2, held as a quotient and a remainder that are stepped by additions.
class EdgeWalk {
 public:
  EdgeWalk() = default;
  EdgeWalk(const selvage_vertex& a, const selvage_vertex& b, int32_t first_row_px,
           int32_t end_row_px);

  [[nodiscard]] int32_t first_row_px() const { return first_row_px_; }
  [[nodiscard]] int32_t end_row_px() const { return end_row_px_; }
  [[nodiscard]] int32_t column_px() const { return static_cast<int32_t>(column_px_); }

  void step() {
    column_px_ += step_px_;
    rest_ += step_rest_;
    const int64_t carry = rest_ >= denominator_;
    column_px_ += carry;
    rest_ -= carry * denominator_;
  }

 private:
  int32_t first_row_px_ = 0, end_row_px_ = 0;
  int64_t column_px_ = 0, rest_ = 0, step_px_ = 0, step_rest_ = 0, denominator_ = 1;
};

// The edges that cross a row of the target, highest first.
struct EdgeList {
  std::array<EdgeWalk, kMaxPolygonVertices> edges;
  size_t count = 0;
};

[[nodiscard]] EdgeList edges_of(std::span<const selvage_vertex> polygon, int32_t height_px);

// Calls draw(Span) for each row of the polygon that shows in a target of that size.
template <typename Draw>
void for_each_span(std::span<const selvage_vertex> polygon, int32_t width_px, int32_t height_px,
                   const Draw& draw) {
  EdgeList list = edges_of(polygon, height_px);
  if (list.count < 2) return;
  EdgeWalk* a = &list.edges[0];
  EdgeWalk* b = &list.edges[1];
  size_t next = 2;
  for (int32_t y = a->first_row_px();; ++y) {
    if (y == a->end_row_px()) {
      if (next == list.count) return;
      a = &list.edges[next++];
    }
    if (y == b->end_row_px()) {
      if (next == list.count) return;
      b = &list.edges[next++];
    }
    const int32_t left = std::min(a->column_px(), b->column_px());
    const int32_t right = std::max(a->column_px(), b->column_px());
    const Span span{y, std::max(left, 0), std::min(right, width_px)};
    if (span.left_px < span.right_px) draw(span);
    a->step();
    b->step();
  }
}

// Pixels of the target that the workload's polygons cover, one on two of them twice.
[[nodiscard]] uint64_t count_covered(const Workload& load);

}  // namespace selvage::reports
