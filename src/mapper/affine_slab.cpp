#include "mapper/affine_slab.h"

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

// SpanMap's numbers for q = 1, which every q cancels to where all are equal.
void AffineSlab::find_lanes(const SpanBatch& batch, RuledRows* rows) const {
  const int64_t left_height = left_.height(), right_height = right_.height();
  for (int32_t i = 0; i < batch.rows; ++i) {
    const Span span = batch.span(i);
    if (span.empty()) continue;
    const AffineEdge::Point left = left_.at(span.row - first_row_);
    const AffineEdge::Point right = right_.at(span.row - first_row_);
    const int64_t weight_left = right.x - centre_fx8(span.left_px) * right_height;
    const int64_t weight_right = centre_fx8(span.left_px) * left_height - left.x;
    const auto start = [&](int64_t at_left, int64_t at_right) {
      return int128{at_left} * weight_left + int128{at_right} * weight_right;
    };
    const auto step = [&](int64_t at_left, int64_t at_right) {
      return (int128{at_right} * left_height - int128{at_left} * right_height) * kSubpixels;
    };
    const LaneDivisor width((int128{right.x} * left_height - int128{left.x} * right_height)
                            << kTexelFraction);
    const auto row = static_cast<size_t>(i);
    rows->start[row] = {width.floor_fx32(start(left.u, right.u)),
                        width.floor_fx32(start(left.v, right.v))};
    // Only where two pixels lie in a span is the step below 2^16.
    rows->step[row] = span.width_px() == 1 ? Lane{}
                                           : Lane{width.floor_fx32(step(left.u, right.u)),
                                                  width.floor_fx32(step(left.v, right.v))};
  }
  rows->margin_fx32 = kAffineErrorPerPixel_fx32 * static_cast<uint32_t>(batch.widest_px);
}

}  // namespace selvage::mapper
