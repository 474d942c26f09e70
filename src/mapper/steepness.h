// How far apart the texels of neighbouring pixels are at most, along a span in perspective.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "mapper/lanes.h"

namespace selvage::mapper {

// What cancellation may hide of the difference of two products, as a share of their sum: doubles
// round each of them, and the difference, by less than 2^-50.
inline constexpr double kHiddenByCancellation = 0x1p-40;

// No less than |n' d - n d'|, which is the same anywhere on the line. Where u is far from 0 and d
// steep, what cancellation hides of it may be more than lanes lack, and is added.
[[nodiscard]] inline double most_rise(const DividedLanes::Linear& numerator,
                                      const DividedLanes::Linear& denominator) {
  const double rise = numerator.step * denominator.start;
  const double turn = numerator.start * denominator.step;
  return std::abs(rise - turn) + kHiddenByCancellation * (std::abs(rise) + std::abs(turn));
}

// No less than u or v changes by from a pixel of the span to the next: that over the least d
// squared.
[[nodiscard]] inline double steepest_fx32(const DividedLanes::Linear& numerator_fx32,
                                          const DividedLanes::Linear& denominator,
                                          int32_t width_px) {
  const double last = denominator.start + (width_px - 1) * denominator.step;
  const double least = std::min(denominator.start, last);
  return most_rise(numerator_fx32, denominator) / (least * least);
}

}  // namespace selvage::mapper
