#include "mapper/plane_lanes.h"

#include <cmath>

namespace selvage::mapper {
namespace {

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
static_assert(kPlaneAreaBits + 3 < 63 && kPlaneEstimateError_fx32 + 2 <= 8,
              "the remainder fits int64_t");

// One coordinate. spec/proofs/plane_estimate.g bounds the error of the estimates.
[[nodiscard]] bool find_lane(const PlaneFrame& frame, int32_t selvage_vertex::*of,
                             int64_t Lane::*axis, AffineField* lanes) {
  const int64_t area = frame.doubled_area();
  const auto [along_x, along_y] = frame.gradient_of(of);
  const auto [dx, dy] = WayToStart(frame, *lanes);
  const double texel = 65536.0 / static_cast<double>(area);
  const double step_x = static_cast<double>(along_x) * (texel * kSubpixels);
  const double step_y = static_cast<double>(along_y) * (texel * kSubpixels);
  const double rise_x = static_cast<double>(dx) * static_cast<double>(along_x) * texel;
  const double rise_y = static_cast<double>(dy) * static_cast<double>(along_y) * texel;
  if (!(std::abs(step_x) + std::abs(step_y) + std::abs(rise_x) + std::abs(rise_y) <
        kMostPlaneEstimate_fx32)) {
    return false;
  }
  const auto low = [](int64_t a) { return static_cast<uint64_t>(a); };
  const uint64_t rise = low(dx) * low(along_x) + low(dy) * low(along_y);
  lanes->step_x.*axis = corrected_floor(step_x, low(along_x) << kPlaneStepShift, area);
  lanes->step_y.*axis = corrected_floor(step_y, low(along_y) << kPlaneStepShift, area);
  lanes->start.*axis = (int64_t{frame.origin().*of} << kPlaneStartShift) +
                       corrected_floor(rise_x + rise_y, rise << kPlaneStartShift, area);
  return true;
}

}  // namespace

bool find_lanes_scalar(const PlaneFrame& frame, AffineField* lanes) {
  return find_lane(frame, &selvage_vertex::u, &Lane::u_fx32, lanes) &&
         find_lane(frame, &selvage_vertex::v, &Lane::v_fx32, lanes);
}

}  // namespace selvage::mapper
