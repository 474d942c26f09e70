// Edges: where they cross a scan line, exactly, and what they carry there.
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>

#include "mapper/number.h"
#include "mapper/polygon.h"

namespace selvage::mapper {

// Of an edge's quotients and their divisors: columns over 256 times the height, and the whole part
// of dx / height.
inline constexpr int kColumnBits = kPositionBits - kSubpixelBits + 1;
inline constexpr int kColumnDivisorBits = kPositionBits + kSubpixelBits;
inline constexpr int kStepBits = kPositionBits + 1;
inline constexpr int kStepDivisorBits = kPositionBits;

// A point of an edge on a scan line. Every value is a numerator over the edge's height.
struct EdgePoint {
  int64_t height;  // 1/256 px, > 0
  int64_t x;       // 1/256 px * height
  int128 uq, vq;   // 1/65536 texel * q * height
  int64_t q;       // q * height
};

// Where an edge crosses rows: the first pixel centre at or right of it, i rows below some row, is
// floor((dividend + i step) / divisor). All are whole and exact in double.
struct EdgeLine {
  double dividend, step, divisor;
};
static_assert(kPositionBits - 1 + kPositionBits < 53, "the dividend is exact in double");

// Of the edge between two vertices, of which the first is not below the second:
// ceil((x - 128 height) / (256 height)), as a floor, x being 256 dx more a row.
[[nodiscard]] inline EdgeLine line_between(const selvage_vertex& top, const selvage_vertex& bottom,
                                           int32_t row) {
  const int64_t height = int64_t{bottom.y} - top.y;
  const int64_t dx = int64_t{bottom.x} - top.x;
  const int64_t x = top.x * height + dx * (centre_fx8(row) - top.y);
  const int64_t divisor = kSubpixels * height;
  return {static_cast<double>(x - kHalfPixel * height + divisor - 1),
          static_cast<double>(kSubpixels * dx), static_cast<double>(divisor)};
}

// floor(a / b) for whole a and b > 0. Rounded once, the quotient floors right: a whole one is
// exact, any other is at least 1 / b from the next whole number, and rounding moves it by less
// (spec/proofs/edge_quotient.g).
[[nodiscard]] inline int64_t floor_quotient(double a, double b) {
  const double quotient = a / b;
  const auto toward_zero = static_cast<int64_t>(quotient);
  return toward_zero - (static_cast<double>(toward_zero) > quotient ? 1 : 0);
}

// How far an edge goes: the change of each value of EdgePoint from its top to its bottom, not times
// the height. Per 1/256 px of y it is what the numerators change by.
struct EdgeChange {
  int64_t x, uq, vq, q;
};

// An edge between two vertices, kept from top to bottom whichever way the outline runs, so that the
// two polygons on its sides compute the same numbers. It steps from row to row by additions: the
// first pixel centre at or right of the edge is a quotient whose remainder is carried along.
class Edge {
 public:
  // An edge that crosses no row.
  Edge() = default;
  Edge(const selvage_vertex& a, const selvage_vertex& b) { join(a, b); }

  void join(const selvage_vertex& a, const selvage_vertex& b) {
    const bool down = a.y <= b.y;
    top_ = down ? &a : &b;
    bottom_ = down ? &b : &a;
    bottom_row_ = first_centre_px(bottom_->y);
  }

  // Of an edge that crosses some row.
  [[nodiscard]] const selvage_vertex& top() const { return *top_; }
  [[nodiscard]] const selvage_vertex& bottom() const { return *bottom_; }

  // The first row below it: it crosses the rows whose centres lie in [y of its top, y of its
  // bottom).
  [[nodiscard]] int32_t bottom_row() const { return bottom_row_; }

  // Goes to a row that it crosses, by one division.
  void seek(int32_t row);
  // Goes to the next row down.
  void step() {
    first_px_ += step_px_;
    remainder_ += step_remainder_;
    if (remainder_ >= divisor_) {
      remainder_ -= divisor_;
      ++first_px_;
    }
  }

  // Of the rows from this one on, which it crosses.
  [[nodiscard]] EdgeLine line_from(int32_t row) const { return line_between(*top_, *bottom_, row); }

  // The least column whose centre is at or right of the edge: ceil(x - 1/2), at the current row.
  [[nodiscard]] int32_t first_px() const { return static_cast<int32_t>(first_px_); }

  [[nodiscard]] EdgePoint at(int32_t row) const { return at(row, top_->q, bottom_->q); }
  // The same where all vertices of a map have one q, which cancels: with 1 for it.
  [[nodiscard]] EdgePoint at_one_q(int32_t row) const { return at(row, 1, 1); }
  [[nodiscard]] EdgeChange change() const;

 private:
  [[nodiscard]] EdgePoint at(int32_t row, int32_t top_q, int32_t bottom_q) const;

  const selvage_vertex* top_ = nullptr;
  const selvage_vertex* bottom_ = nullptr;
  int32_t bottom_row_ = std::numeric_limits<int32_t>::min();
  int64_t divisor_ = 1;  // 256 * height: what a pixel's width is in the units of EdgePoint::x
  int64_t first_px_ = 0, remainder_ = 0;
  int64_t step_px_ = 0, step_remainder_ = 0;
};

// One of the two chains of edges from a polygon's top to its bottom.
class Chain {
 public:
  enum class Direction { kForward, kBackward };  // through the vertices
  Chain(const Polygon& polygon, Direction direction)
      : polygon_(&polygon), direction_(direction), vertex_(polygon.top) {}

  // The edge that crosses `row`, at that row. Rows must rise from call to call and stay within the
  // polygon's; they may jump.
  [[nodiscard]] const Edge& at_row(int32_t row);
  // The same edge, at no row in particular.
  [[nodiscard]] const Edge& crossing(int32_t row) {
    while (row >= edge_.bottom_row()) next_edge();
    return edge_;
  }

  // Calls find(line, rows, first) for each edge that crosses some of the rows [row, end_row), the
  // line from its first one there, which is `first` rows below `row`. Under the same rule.
  template <class Find>
  void for_each_line(int32_t row, int32_t end_row, const Find& find) {
    for (int32_t next = row; next < end_row;) {
      const Edge& edge = crossing(next);
      const int32_t stop = std::min(end_row, edge.bottom_row());
      find(edge.line_from(next), stop - next, next - row);
      next = stop;
    }
  }

 private:
  void next_edge() {
    const size_t count = polygon_->vertices.size();
    const size_t from = vertex_;
    row_ = kNoRow;
    if (direction_ == Direction::kForward) {
      vertex_ = from + 1 == count ? 0 : from + 1;
    } else {
      vertex_ = from == 0 ? count - 1 : from - 1;
    }
    edge_.join(polygon_->vertices[from], polygon_->vertices[vertex_]);
  }

  static constexpr int32_t kNoRow = std::numeric_limits<int32_t>::min();

  const Polygon* polygon_;
  Direction direction_;
  size_t vertex_;         // the end of edge_, where the next edge starts
  int32_t row_ = kNoRow;  // that edge_ is at
  Edge edge_;
};

}  // namespace selvage::mapper
