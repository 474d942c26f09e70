#include "mapper/plane.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace selvage::mapper {
namespace {

static_assert(kTexelBits + 1 + kPositionBits + 1 <= 57, "A and B of a plane are below 2^57");

// floor(n / d) where an estimate in double is off by kPlaneEstimateError_fx32 at most, and all that
// is known of n is its low 64 bits: they tell the remainder of a quotient that is off by little.
[[nodiscard]] int64_t corrected_floor(double estimate, uint64_t n_low, int64_t d) {
  auto quotient = static_cast<int64_t>(estimate);
  auto remainder =
      static_cast<int64_t>(n_low - static_cast<uint64_t>(quotient) * static_cast<uint64_t>(d));
  // Below zero as good as at random, for the estimate is truncated: without a branch.
  const int64_t below = remainder >> 63;
  quotient += below;
  remainder += below & d;
  for (; remainder < 0; remainder += d) --quotient;
  for (; remainder >= d; remainder -= d) ++quotient;
  return quotient;
}

[[nodiscard]] PlaneCoordinate coordinate(const PlaneFrame& frame, int32_t selvage_vertex::*of) {
  const int32_t value_fx16 = frame.origin().*of;
  const auto gradient = frame.gradient<int64_t>(int64_t{frame.second().*of} - value_fx16,
                                                int64_t{frame.third().*of} - value_fx16);
  return {value_fx16, gradient.along_x, gradient.along_y};
}

static_assert(kPlaneAreaBits + 3 < 63 && kPlaneEstimateError_fx32 + 2 <= 8,
              "the remainder fits int64_t");

}  // namespace

Plane::Plane(const PlaneFrame& frame)
    : x_fx8_(frame.origin().x),
      y_fx8_(frame.origin().y),
      doubled_area_(frame.doubled_area()),
      u_(coordinate(frame, &selvage_vertex::u)),
      v_(coordinate(frame, &selvage_vertex::v)) {}

bool Plane::passes_through(const selvage_vertex& vertex) const {
  const int64_t dx = int64_t{vertex.x} - x_fx8_, dy = int64_t{vertex.y} - y_fx8_;
  const auto lies_on = [&](const PlaneCoordinate& c, int32_t at_fx16) {
    return int128{int64_t{at_fx16} - c.origin_fx16} * doubled_area_ ==
           int128{dx} * c.along_x + int128{dy} * c.along_y;
  };
  return lies_on(u_, vertex.u) && lies_on(v_, vertex.v);
}

// In fx32, a step of a pixel is 2^16 * 2^8 A / D, and the start is 2^16 (dx A + dy B) / D above the
// origin's. spec/proofs/plane_estimate.g bounds the error of the estimates.
bool Plane::set_lane(const PlaneCoordinate& c, int64_t Lane::*axis) {
  const double texel = 65536.0 / static_cast<double>(doubled_area_);
  const double step_x = static_cast<double>(c.along_x) * (texel * kSubpixels);
  const double step_y = static_cast<double>(c.along_y) * (texel * kSubpixels);
  const int64_t dx = centre_fx8(lanes_.first_px) - int64_t{x_fx8_};
  const int64_t dy = centre_fx8(lanes_.first_row) - int64_t{y_fx8_};
  const double rise_x = static_cast<double>(dx) * static_cast<double>(c.along_x) * texel;
  const double rise_y = static_cast<double>(dy) * static_cast<double>(c.along_y) * texel;
  if (!(std::abs(step_x) + std::abs(step_y) + std::abs(rise_x) + std::abs(rise_y) <
        kMostPlaneEstimate_fx32)) {
    return false;
  }
  const auto low = [](int64_t a) { return static_cast<uint64_t>(a); };
  const uint64_t rise = low(dx) * low(c.along_x) + low(dy) * low(c.along_y);
  constexpr int kStepShift = kTexelFraction + kSubpixelBits;
  lanes_.step_x.*axis = corrected_floor(step_x, low(c.along_x) << kStepShift, doubled_area_);
  lanes_.step_y.*axis = corrected_floor(step_y, low(c.along_y) << kStepShift, doubled_area_);
  lanes_.start.*axis = (int64_t{c.origin_fx16} << kTexelFraction) +
                       corrected_floor(rise_x + rise_y, rise << kTexelFraction, doubled_area_);
  return true;
}

bool Plane::is_of(std::span<const selvage_vertex> vertices) const {
  if (doubled_area_ == 0) return false;
  const auto is_on = [&](const selvage_vertex& vertex) { return passes_through(vertex); };
  return vertices.size() == 3 || std::ranges::all_of(vertices.subspan(1), is_on);
}

bool Plane::set_lanes(const Polygon& polygon, const selvage_rect& visible) {
  lanes_.first_px = std::max(visible.left, polygon.left_px);
  lanes_.first_row = std::max(visible.top, polygon.top_row);
  const int32_t end_px = std::min(visible.right, polygon.right_px);
  const int32_t end_row = std::min(visible.bottom, polygon.bottom_row);
  const int32_t steps = std::max(end_px - lanes_.first_px + end_row - lanes_.first_row, 0) + 1;
  lanes_.margin_fx32 = kPlaneErrorPerStep_fx32 * static_cast<uint32_t>(steps);
  return set_lane(u_, &Lane::u_fx32) && set_lane(v_, &Lane::v_fx32);
}

// The plane is made in its place: a copy would load by sixteens of bytes what was just stored by
// eights, and wait for it.
std::optional<Plane> Plane::of(const Polygon& polygon, const selvage_rect& visible) {
  std::optional<Plane> plane(std::in_place, PlaneFrame::of(polygon.vertices));
  if (!polygon.affine || !plane->is_of(polygon.vertices) || !plane->set_lanes(polygon, visible)) {
    plane.reset();
  }
  return plane;
}

}  // namespace selvage::mapper
