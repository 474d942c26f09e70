// The affine lanes of rows, each by the map between its own two edges.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "mapper/lanes.h"
#include "mapper/number.h"
#include "mapper/slab.h"
#include "mapper/span_batch.h"

namespace selvage::mapper {

// Exact floors of the lanes of spans' first pixels and of their steps.
struct RuledRows {
  std::array<Lane, kRowsPerBatch> start, step;
  uint32_t margin_fx32;  // of the lane furthest from its start

  [[nodiscard]] AffineLanes lanes(int32_t index) const {
    const auto i = static_cast<size_t>(index);
    return {start[i], step[i], margin_fx32};
  }
};

// An edge of one q, by numbers that are linear in the row, all of them times its height.
//
//   name   unit                      bits
//   x      1/256 px * height           49
//   u, v   1/65536 texel * height      56
class AffineEdge {
 public:
  AffineEdge(const Edge& edge, int32_t first_row);

  struct Point {
    int64_t x, u, v;
  };
  [[nodiscard]] Point at(int32_t rows_below) const {
    return {first_.x + rows_below * down_.x, first_.u + rows_below * down_.u,
            first_.v + rows_below * down_.v};
  }
  [[nodiscard]] int64_t height() const { return height_; }

 private:
  int64_t height_;
  Point first_, down_;
};

class AffineSlab {
 public:
  explicit AffineSlab(const Slab& slab)
      : first_row_(slab.first_row), a_(slab.a, slab.first_row), b_(slab.b, slab.first_row) {}

  // Of some of a batch's rows, the slab's. Those of empty spans are 0.
  void find_lanes(const SpanBatch& batch, int32_t first_index, int32_t end_index,
                  RuledRows* rows) const;

 private:
  int32_t first_row_;
  AffineEdge a_, b_;
};

// Of a batch of the slabs' rows.
void find_lanes(std::span<const Slab> slabs, const SpanBatch& batch, RuledRows* rows);

}  // namespace selvage::mapper
