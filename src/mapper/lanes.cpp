#include "mapper/lanes.h"

#include <algorithm>

#include "mapper/lane_divisor.h"

namespace selvage::mapper {
namespace {

inline constexpr double kLaneUnit = 4294967296.0;  // 2^kLaneFraction

[[nodiscard]] double ratio_of_ends(const SpanMap& map, const Span& span) {
  const auto at_start = static_cast<double>(map.denominator(span.left_px));
  const auto at_end = static_cast<double>(map.denominator(span.right_px - 1));
  return std::max(at_start, at_end) / std::min(at_start, at_end);
}

}  // namespace

AffineLanes::AffineLanes(const SpanMap& map, const Span& span)
    : margin_fx32_(kAffineErrorPerPixel_fx32 * static_cast<uint32_t>(span.width_px())) {
  const LaneDivisor denominator(map.denominator(span.left_px));
  start_ = Lane{denominator.floor_fx32(map.u_numerator(span.left_px)),
                denominator.floor_fx32(map.v_numerator(span.left_px))};
  // A single pixel needs no step, and only where two pixels lie in a span is the step below 2^16.
  if (span.width_px() > 1) {
    step_ = Lane{denominator.floor_fx32(map.u_numerator_step()),
                 denominator.floor_fx32(map.v_numerator_step())};
  }
}

// The bound. Let e = 2^-53, N(i) = N0 + i dN a numerator and D(i) the denominator, U = 2^15 >= |u|,
// and D_min, D_max the denominators at the span's ends, in either order. Converting and stepping
// costs e (|N0| + 2 |i dN| + |N|) <= 6 e U D_max in a numerator, likewise 4 e D_max in the
// denominator, which is positive; the reciprocal and its product 2 e U more. Therefore
//
//     |error of u| <= e (10 U D_max / D_min + 2 U) (1 + 2^-20) <= 12 e U D_max / D_min (1 + 2^-20),
//
// which in units of 2^-32 texel is 12 * 2^(15 + 32 - 53) D_max / D_min, 3/16 of the ratio and a
// little. q is at most 2^24, so the ratio is at most 2^24 and the denominator never near 0.
ProjectiveLanes::ProjectiveLanes(const SpanMap& map, const Span& span, double ratio)
    : DividedLanes({static_cast<double>(map.u_numerator(span.left_px)) * kLaneUnit,
                    static_cast<double>(map.u_numerator_step()) * kLaneUnit},
                   {static_cast<double>(map.v_numerator(span.left_px)) * kLaneUnit,
                    static_cast<double>(map.v_numerator_step()) * kLaneUnit},
                   {static_cast<double>(map.denominator(span.left_px)),
                    static_cast<double>(map.denominator_step())},
                   static_cast<int64_t>(ratio) + kProjectiveTruncations_fx32),
      ratio_(ratio) {}

ProjectiveLanes::ProjectiveLanes(const SpanMap& map, const Span& span)
    : ProjectiveLanes(map, span, ratio_of_ends(map, span)) {}

ProjectiveField ProjectiveLanes::field(const Span& span) const {
  const auto line = [](const Linear& along) {
    return ProjectiveField::Form{along.start, along.step, 0};
  };
  return {span.left_px,        span.row,    line(u_numerator_fx32()), line(v_numerator_fx32()),
          line(denominator()), error_fx32()};
}

}  // namespace selvage::mapper
