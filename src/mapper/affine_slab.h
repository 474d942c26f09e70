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

// Lanes at the starts of spans are estimated in double, and so are steps where there are two pixels
// or more. Estimates are off by at most so much; lowered by the slack and floored they are low, by
// less than kRuledErrorPerPixel_fx32.
inline constexpr double kRuledError_fx32 = 0.35, kRuledSlack_fx32 = 0.5;
inline constexpr uint32_t kRuledErrorPerPixel_fx32 = 2;
static_assert(kWidestMargin_fx32 >= int64_t{kRuledErrorPerPixel_fx32} << 16);

// The lanes of spans' first pixels, and their steps. With room for a vector that begins in the last
// row.
struct RuledRows {
  std::array<Lane, kRowsPerBatch + kMostLanes> start, step;
  uint32_t margin_fx32;     // of the lane furthest from its start
  double most_denominator;  // that of a row's exact map is no greater, but for 2^-50 of it

  [[nodiscard]] AffineLanes lanes(int32_t index) const {
    const auto i = static_cast<size_t>(index);
    return {start[i], step[i], margin_fx32};
  }
};

// An edge of one q, by numbers that are linear in the row, all of them times its height.
//
//   name   unit                      bits
//   x      1/256 px * height           49   exact in double
//   u, v   1/65536 texel * height      56   rounded
class AffineEdge {
 public:
  AffineEdge(const Edge& edge, int32_t first_row);

  struct Point {
    double x, u, v;
  };
  [[nodiscard]] Point at(int32_t rows_below) const {
    const double n = rows_below;
    return {first_.x + n * down_.x, first_.u + n * down_.u, first_.v + n * down_.v};
  }
  // In the first row, and how much more a row.
  [[nodiscard]] const Point& first() const { return first_; }
  [[nodiscard]] const Point& down() const { return down_; }
  [[nodiscard]] double height() const { return height_; }

 private:
  double height_;
  Point first_, down_;
};

struct AffineSlab {
  explicit AffineSlab(const Slab& slab)
      : first_row(slab.first_row), a(slab.a, slab.first_row), b(slab.b, slab.first_row) {}

  int32_t first_row;
  AffineEdge a, b;
};

// Of some of a batch's rows, the slab's. Those of empty spans are 0. Raises most_denominator. Less
// than kMostLanes rows behind end_index may be written, too: slabs are asked from top to bottom.
using FindRuledLanes = void (*)(const AffineSlab& slab, const SpanBatch& batch, int32_t first_index,
                                int32_t end_index, RuledRows* rows);

void find_ruled_lanes_scalar(const AffineSlab& slab, const SpanBatch& batch, int32_t first_index,
                             int32_t end_index, RuledRows* rows);

// Of a batch of the slabs' rows, each slab's by find_ruled_lanes.
void find_lanes(std::span<const Slab> slabs, const SpanBatch& batch,
                FindRuledLanes find_ruled_lanes, RuledRows* rows);
// Of some of its rows alone, those of these spans.
void find_lanes_of(const RuledMap& map, const SpanBatch& batch, std::span<const Span> of,
                   RuledRows* rows);

}  // namespace selvage::mapper
