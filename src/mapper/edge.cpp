#include "mapper/edge.h"

#include <algorithm>
#include <utility>

namespace selvage::mapper {
namespace {

// The mean of a and b at a height `below_top` of `height`, times height.
[[nodiscard]] int128 interpolate(int64_t a, int64_t b, int64_t below_top, int64_t height) {
  return int128{a} * (height - below_top) + int128{b} * below_top;
}

static_assert(kPositionBits + kPositionBits + kSubpixelBits < 63, "Edge steps fit int64_t");

// floor(a / b) for whole a and b > 0 that are exact in double. Rounded once, the quotient floors
// right: a whole one is exact, any other is at least 1 / b from the next whole number, and rounding
// moves it by less (spec/proofs/edge_quotient.g).
[[nodiscard]] int64_t floor_quotient(int64_t a, int64_t b) {
  const double quotient = static_cast<double>(a) / static_cast<double>(b);
  const auto toward_zero = static_cast<int64_t>(quotient);
  return toward_zero - (static_cast<double>(toward_zero) > quotient ? 1 : 0);
}

static_assert(kPositionBits - 1 + kPositionBits < 53, "Edge::seek's dividend is exact in double");

}  // namespace

Edge::Edge(const selvage_vertex& a, const selvage_vertex& b) : top_(&a), bottom_(&b) {
  if (bottom_->y < top_->y) std::swap(top_, bottom_);
  bottom_row_ = first_centre_px(bottom_->y);
}

void Edge::seek(int32_t row) {
  const int64_t height = int64_t{bottom_->y} - top_->y;
  const int64_t dx = int64_t{bottom_->x} - top_->x;
  const int64_t x = top_->x * height + dx * (centre_fx8(row) - top_->y);
  // ceil((x - 128 height) / (256 height)), as a floor.
  divisor_ = kSubpixels * height;
  const int64_t dividend = x - kHalfPixel * height + divisor_ - 1;
  first_px_ = floor_quotient(dividend, divisor_);
  remainder_ = dividend - first_px_ * divisor_;
  step_px_ = floor_quotient(dx, height);
  step_remainder_ = kSubpixels * (dx - step_px_ * height);
}

// Steps as step() does, but on copies that stay in registers and without a branch: carries come as
// good as at random.
void Edge::columns(int32_t row, int32_t end_row, int32_t* first_px) {
  seek(row);
  int64_t column_px = first_px_, remainder = remainder_;
  for (int32_t i = 0; i < end_row - row; ++i) {
    first_px[i] = static_cast<int32_t>(column_px);
    remainder += step_remainder_ - divisor_;
    const int64_t borrow = remainder >> 63;  // -1 where there is no carry
    remainder += borrow & divisor_;
    column_px += step_px_ + 1 + borrow;
  }
}

EdgePoint Edge::at(int32_t row) const {
  const int64_t height = int64_t{bottom_->y} - top_->y;
  const int64_t below_top = centre_fx8(row) - int64_t{top_->y};
  return EdgePoint{
      .height = height,
      .x = static_cast<int64_t>(interpolate(top_->x, bottom_->x, below_top, height)),
      .uq = interpolate(int64_t{top_->u} * top_->q, int64_t{bottom_->u} * bottom_->q, below_top,
                        height),
      .vq = interpolate(int64_t{top_->v} * top_->q, int64_t{bottom_->v} * bottom_->q, below_top,
                        height),
      .q = static_cast<int64_t>(interpolate(top_->q, bottom_->q, below_top, height)),
  };
}

Chain::Chain(const Polygon& polygon, Direction direction)
    : polygon_(&polygon), direction_(direction), vertex_(polygon.top) {}

void Chain::next_edge() {
  const size_t count = polygon_->vertices.size();
  const size_t from = vertex_;
  if (direction_ == Direction::kForward) {
    vertex_ = from + 1 == count ? 0 : from + 1;
  } else {
    vertex_ = from == 0 ? count - 1 : from - 1;
  }
  edge_ = Edge(polygon_->vertices[from], polygon_->vertices[vertex_]);
}

const Edge& Chain::at_row(int32_t row) {
  if (row < edge_.bottom_row() && row == row_ + 1) {
    edge_.step();
  } else {
    while (row >= edge_.bottom_row()) next_edge();
    edge_.seek(row);
  }
  row_ = row;
  return edge_;
}

void Chain::columns(int32_t row, int32_t end_row, int32_t* first_px) {
  while (row < end_row) {
    while (row >= edge_.bottom_row()) next_edge();
    const int32_t stop = std::min(end_row, edge_.bottom_row());
    edge_.columns(row, stop, first_px);
    first_px += stop - row;
    row = stop;
  }
}

}  // namespace selvage::mapper
