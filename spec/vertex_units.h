// The numbers of a vertex: their units and their ranges.
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>

#include "selvage.h"

namespace selvage::spec {

inline constexpr int32_t kPixel_fx8 = SELVAGE_SUBPIXELS;
inline constexpr int32_t kHalfPixel_fx8 = kPixel_fx8 / 2;
inline constexpr int32_t kTexel_fx16 = SELVAGE_SUBTEXELS;

inline constexpr int32_t kQMax = SELVAGE_Q_MAX;
inline constexpr int64_t kLeastCoordinate_fx16 = std::numeric_limits<int32_t>::min();
inline constexpr int64_t kGreatestCoordinate_fx16 = std::numeric_limits<int32_t>::max();

// x, y, u, v or q.
using VertexField = int32_t selvage_vertex::*;

// The nearest x or y that is accepted.
[[nodiscard]] constexpr int32_t clamped_position(int64_t fx8) {
  return static_cast<int32_t>(std::clamp<int64_t>(fx8, SELVAGE_X_MIN, SELVAGE_X_END - 1));
}

// The nearest u or v that there is.
[[nodiscard]] constexpr int32_t clamped_coordinate(int64_t fx16) {
  return static_cast<int32_t>(std::clamp(fx16, kLeastCoordinate_fx16, kGreatestCoordinate_fx16));
}

}  // namespace selvage::spec
