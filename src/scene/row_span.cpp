#include "scene/row_span.h"

#include <algorithm>

namespace selvage::scene {

RowSpan::RowSpan(const ActiveEdge& a, const ActiveEdge& b) : face_(a.face()) {
  const Signed128 ahead = Signed128{b.x()} * a.height() - Signed128{a.x()} * b.height();
  if (ahead == 0) return;
  const ActiveEdge& left = ahead > 0 ? a : b;
  const ActiveEdge& right = ahead > 0 ? b : a;
  first_px_ = left.first_px();
  end_px_ = right.first_px();
  at_origin_ = Signed128{left.q()} * right.x() - Signed128{right.q()} * left.x();
  slope_ = Signed128{right.q()} * left.height() - Signed128{left.q()} * right.height();
  denominator_ = ahead > 0 ? ahead : -ahead;
}

void RowSpan::clip(int32_t width_px) {
  first_px_ = std::max(first_px_, 0);
  end_px_ = std::min(end_px_, width_px);
}

Fraction RowSpan::nearness(int32_t x_px) const {
  const int64_t centre = int64_t{x_px} * SELVAGE_SUBPIXELS + SELVAGE_SUBPIXELS / 2;
  return {static_cast<Unsigned128>(at_origin_ + slope_ * centre),
          static_cast<Unsigned128>(denominator_)};
}

bool RowSpan::hides(const RowSpan& other, int32_t x_px) const {
  const std::strong_ordering order = compare(nearness(x_px), other.nearness(x_px));
  return order > 0 || (order == 0 && face_ < other.face_);
}

}  // namespace selvage::scene
