#include "mapper/edge.h"

namespace selvage::mapper {
namespace {

// The mean of a and b at a height `below_top` of `height`, times height.
[[nodiscard]] int128 interpolate(int64_t a, int64_t b, int64_t below_top, int64_t height) {
  return int128{a} * (height - below_top) + int128{b} * below_top;
}

static_assert(kPositionBits + kPositionBits + kSubpixelBits < 63, "Edge steps fit int64_t");

}  // namespace

void Edge::seek(int32_t row) {
  const int64_t height = int64_t{bottom_->y} - top_->y;
  const int64_t dx = int64_t{bottom_->x} - top_->x;
  const EdgeLine line = line_from(row);
  const auto dividend = static_cast<int64_t>(line.dividend);
  divisor_ = kSubpixels * height;
  first_px_ = floor_quotient(line.dividend, line.divisor);
  remainder_ = dividend - first_px_ * divisor_;
  step_px_ = floor_quotient(static_cast<double>(dx), static_cast<double>(height));
  step_remainder_ = kSubpixels * (dx - step_px_ * height);
}

EdgePoint Edge::at(int32_t row, int32_t top_q, int32_t bottom_q) const {
  const int64_t height = int64_t{bottom_->y} - top_->y;
  const int64_t below_top = centre_fx8(row) - int64_t{top_->y};
  return EdgePoint{
      .height = height,
      .x = static_cast<int64_t>(interpolate(top_->x, bottom_->x, below_top, height)),
      .uq =
          interpolate(int64_t{top_->u} * top_q, int64_t{bottom_->u} * bottom_q, below_top, height),
      .vq =
          interpolate(int64_t{top_->v} * top_q, int64_t{bottom_->v} * bottom_q, below_top, height),
      .q = static_cast<int64_t>(interpolate(top_q, bottom_q, below_top, height)),
  };
}

EdgeChange Edge::change() const {
  return EdgeChange{
      .x = int64_t{bottom_->x} - top_->x,
      .uq = int64_t{bottom_->u} * bottom_->q - int64_t{top_->u} * top_->q,
      .vq = int64_t{bottom_->v} * bottom_->q - int64_t{top_->v} * top_->q,
      .q = int64_t{bottom_->q} - top_->q,
  };
}

const Edge& Chain::at_row(int32_t row) {
  if (row < edge_.bottom_row() && row == row_ + 1) {
    edge_.step();
  } else {
    static_cast<void>(crossing(row));
    edge_.seek(row);
  }
  row_ = row;
  return edge_;
}

}  // namespace selvage::mapper
