// Slabs: a polygon cut at the rows where an edge ends.
//
// The same two edges bound all rows of a slab. Where they meet in a vertex they span a triangle,
// and the slab has one map; elsewhere each row has its own, and the slab's are of one formula.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "mapper/edge.h"
#include "mapper/polygon.h"
#include "mapper/span.h"

namespace selvage::mapper {

// Rows [first_row, end_row) between two edges that cross all of them. Refers to the polygon's
// vertices.
struct Slab {
  Edge a, b;  // either may be the left one, from row to row; at no row in particular
  int32_t first_row = 0, end_row = 0;

  [[nodiscard]] int32_t rows() const { return end_row - first_row; }
  // On a row of both. Of one q at all ends, it cancels and is 1: numbers are as short as can be.
  struct Points {
    EdgePoint a, b;
  };
  [[nodiscard]] Points at(int32_t row) const {
    if (has_one_q()) return {a.at_one_q(row), b.at_one_q(row)};
    return {a.at(row), b.at(row)};
  }

 private:
  [[nodiscard]] bool has_one_q() const {
    const int32_t q = a.top().q;
    return a.bottom().q == q && b.top().q == q && b.bottom().q == q;
  }
};

// Fewer rows are drawn one by one, which costs less than setting up a slab.
inline constexpr int32_t kLeastSlabRows = 4;

// From the first visible row to the last.
class SlabWalk {
 public:
  SlabWalk(const Polygon& polygon, const selvage_rect& part)
      : row_(part.top),
        end_row_(part.bottom),
        forward_(polygon, Chain::Direction::kForward),
        backward_(polygon, Chain::Direction::kBackward) {}

  // Empty where no row is left.
  [[nodiscard]] std::optional<Slab> next() {
    if (row_ >= end_row_) return std::nullopt;
    const Edge& a = forward_.crossing(row_);
    const Edge& b = backward_.crossing(row_);
    const int32_t first_row = row_;
    row_ = std::min({a.bottom_row(), b.bottom_row(), end_row_});
    return Slab{a, b, first_row, row_};
  }

 private:
  int32_t row_, end_row_;
  Chain forward_, backward_;
};

// A polygon with the slab's two edges: through their ends, once where they meet.
class SlabOutline {
 public:
  explicit SlabOutline(const Slab& slab);

  // Refers to the outline. Without vertices where both edges are one, and so without pixels.
  [[nodiscard]] Polygon polygon() const;

 private:
  void add(const selvage_vertex& vertex);

  std::array<selvage_vertex, 4> corners_;
  size_t count_ = 0;
};

// The slab with its left edge as `a`; empty where the edges cross within its rows. They may touch
// in the first or the last one, or be the same: such rows have no pixels.
[[nodiscard]] std::optional<Slab> from_left_to_right(const Slab& slab);

// The exact map of each row of some slabs.
class RuledMap {
 public:
  static constexpr size_t kMostSlabs = 4;

  RuledMap() = default;
  explicit RuledMap(const Slab& slab) : count_(1), slabs_{slab} {}

  // The rows right below those before; false where there are kMostSlabs.
  [[nodiscard]] bool add(const Slab& slab) {
    if (count_ == kMostSlabs) return false;
    slabs_[count_++] = slab;
    return true;
  }
  [[nodiscard]] std::span<const Slab> slabs() const { return {slabs_.data(), count_}; }

  // That of a row.
  [[nodiscard]] const Slab& slab_of(int32_t row) const {
    const Slab* slab = slabs_.data();
    while (row >= slab->end_row) ++slab;
    return *slab;
  }
  // Of an affine polygon: no row's denominator is greater, but for roundings.
  [[nodiscard]] double most_denominator() const;
  // Of a row with pixels.
  [[nodiscard]] SpanMap at(int32_t row) const;

 private:
  size_t count_ = 0;
  std::array<Slab, kMostSlabs> slabs_;
};

}  // namespace selvage::mapper
