#include "mapper/affine_slab.h"

#include <algorithm>

#include "mapper/lane_divisor.h"

namespace selvage::mapper {

AffineEdge::AffineEdge(const Edge& edge, int32_t first_row)
    : height_(int64_t{edge.bottom().y} - edge.top().y) {
  const selvage_vertex &top = edge.top(), &bottom = edge.bottom();
  const int64_t below_top = centre_fx8(first_row) - int64_t{top.y};
  const auto start = [&](int64_t a, int64_t b) { return a * height_ + (b - a) * below_top; };
  const auto down = [](int64_t a, int64_t b) { return (b - a) * kSubpixels; };
  first_ = {start(top.x, bottom.x), start(top.u, bottom.u), start(top.v, bottom.v)};
  down_ = {down(top.x, bottom.x), down(top.u, bottom.u), down(top.v, bottom.v)};
}
// A mean of two ends times the height, each term twice as large at most.
static_assert(kTexelBits + 2 + kPositionBits < 63 && 2 * kPositionBits + 1 < 63);

namespace {

using Point = AffineEdge::Point;

// SpanMap's numbers for q = 1, which every q cancels to where all are equal.
struct AffineMap {
  Point left, right;
  int64_t left_height, right_height;

  [[nodiscard]] int128 width() const {
    return int128{right.x} * left_height - int128{left.x} * right_height;
  }
  // At the centre of a pixel.
  [[nodiscard]] int128 numerator(int64_t Point::*of, int32_t px) const {
    const int64_t weight_left = right.x - centre_fx8(px) * right_height;
    const int64_t weight_right = centre_fx8(px) * left_height - left.x;
    return int128{left.*of} * weight_left + int128{right.*of} * weight_right;
  }
  // From there to the next.
  [[nodiscard]] int128 step(int64_t Point::*of) const {
    return (int128{right.*of} * left_height - int128{left.*of} * right_height) * kSubpixels;
  }
};

}  // namespace

void AffineSlab::find_lanes(const SpanBatch& batch, int32_t first_index, int32_t end_index,
                            RuledRows* rows) const {
  for (int32_t i = first_index; i < end_index; ++i) {
    const auto row = static_cast<size_t>(i);
    const Span span = batch.span(i);
    rows->start[row] = rows->step[row] = {};
    if (span.empty()) continue;
    AffineMap map{a_.at(span.row - first_row_), b_.at(span.row - first_row_), a_.height(),
                  b_.height()};
    if (map.width() < 0) map = {map.right, map.left, map.right_height, map.left_height};
    const LaneDivisor width(map.width() << kTexelFraction);
    rows->start[row] = {width.floor_fx32(map.numerator(&Point::u, span.left_px)),
                        width.floor_fx32(map.numerator(&Point::v, span.left_px))};
    if (span.width_px() == 1) continue;  // only from pixel to pixel is a step below 2^16
    rows->step[row] = {width.floor_fx32(map.step(&Point::u)),
                       width.floor_fx32(map.step(&Point::v))};
  }
}

void find_lanes(std::span<const Slab> slabs, const SpanBatch& batch, RuledRows* rows) {
  const int32_t end_row = batch.first_row + batch.rows;
  for (const Slab& slab : slabs) {
    const int32_t first = std::max(slab.first_row, batch.first_row);
    const int32_t end = std::min(slab.end_row, end_row);  // before the first one: no row
    AffineSlab(slab).find_lanes(batch, first - batch.first_row, end - batch.first_row, rows);
  }
  rows->margin_fx32 = kAffineErrorPerPixel_fx32 * static_cast<uint32_t>(batch.widest_px);
}

}  // namespace selvage::mapper
