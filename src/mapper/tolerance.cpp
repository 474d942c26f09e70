#include "mapper/tolerance.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace selvage::mapper {
namespace {

inline constexpr double kLaneUnits = 1 << kStepShift;  // of 32.32 in one of 16.16

// What lanes along `steps` steps may lose, the curve apart.
[[nodiscard]] int32_t roundings_fx16(int64_t margin_fx32, int32_t steps) {
  return static_cast<int32_t>((margin_fx32 + kStepError_fx32 * steps) >> kStepShift) +
         kStepRounding_fx16;
}

// The change of u or of v from end to end of a row, whichever is greater; not below the true one.
[[nodiscard]] double change_fx16(const DividedLanes& lanes, int32_t steps) {
  const Lane first = lanes.at(0), last = lanes.at(steps);
  const int64_t change_fx32 =
      std::max(std::abs(last.u_fx32 - first.u_fx32), std::abs(last.v_fx32 - first.v_fx32));
  return static_cast<double>(change_fx32 + lanes.margin_fx32()) / kLaneUnits;
}

// Of the greater denominator at the row's ends to the lesser one.
[[nodiscard]] double ratio_of_ends(const DividedLanes& lanes, int32_t steps) {
  const DividedLanes::Linear& d = lanes.denominator();
  const double at_end = d.start + steps * d.step;
  return std::max(d.start, at_end) / std::min(d.start, at_end);
}

}  // namespace

RowChoice choose_row(const DividedLanes& lanes, int32_t width_px, int32_t tolerance_fx16) {
  constexpr RowChoice kExact = {SELVAGE_METHOD_EXACT_PERSPECTIVE, 0, 0};
  if (width_px < kLeastStepped_px) return kExact;
  const int32_t steps = width_px - 1;
  const int32_t roundings = roundings_fx16(lanes.margin_fx32(), steps);
  const double change = change_fx16(lanes, steps);
  const double ratio = ratio_of_ends(lanes, steps) * kRatioSlack;
  if (roundings > tolerance_fx16) return kExact;

  // Of the whole row's chord; of chords N long it is (N / steps)^2 of this.
  const double curve = change * ratio * (ratio - 1) / 4;
  const int32_t budget = tolerance_fx16 - roundings;
  if (curve <= budget) {
    return {SELVAGE_METHOD_AFFINE_FOR_PERSPECTIVE, 0,
            roundings + static_cast<int32_t>(std::ceil(curve))};
  }
  const auto longest_px = static_cast<int32_t>(steps * std::sqrt(budget / curve * kBudgetSlack));
  const int32_t segment_px = longest_px - longest_px % kStepGroup_px;
  if (segment_px < kLeastSegment_px) return kExact;
  const double part = static_cast<double>(segment_px) / steps;
  const double chord = curve * part * part;
  return {SELVAGE_METHOD_SUBDIVIDED, segment_px,
          roundings + static_cast<int32_t>(std::ceil(chord))};
}

}  // namespace selvage::mapper
