// The polygon: vertices that have passed every check, and where it starts and ends.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

#include "selvage.h"

namespace selvage::mapper {

// The least and the most of u and v at the vertices, and so of all that lies between them.
struct TexelBox {
  int32_t least_u_fx16, least_v_fx16, most_u_fx16, most_v_fx16;

  // The most of |u| and |v|.
  [[nodiscard]] int64_t furthest_fx16() const {
    return std::max(std::max(-int64_t{least_u_fx16}, -int64_t{least_v_fx16}),
                    int64_t{std::max(most_u_fx16, most_v_fx16)});
  }
};

struct Polygon {
  std::span<const selvage_vertex> vertices;
  size_t top = 0;  // the first vertex of least y
  // Columns and rows whose centres lie in [least x, greatest x) and [least y, greatest y).
  int32_t left_px = 0, top_row = 0, right_px = 0, bottom_row = 0;
  TexelBox texels{};
  int32_t least_q = 1;
  bool affine = true;          // all q are equal
  bool untransformed = false;  // u = x + ds and v = y + dt, ds and dt whole, everywhere
  int32_t ds = 0, dt = 0;      // texels; of an untransformed polygon
};

// What is visible of the columns and rows that the polygon has pixels in.
[[nodiscard]] inline selvage_rect part_of(const Polygon& polygon, const selvage_rect& visible) {
  return {std::max(visible.left, polygon.left_px), std::max(visible.top, polygon.top_row),
          std::min(visible.right, polygon.right_px), std::min(visible.bottom, polygon.bottom_row)};
}
[[nodiscard]] inline bool is_empty(const selvage_rect& rect) {
  return rect.left >= rect.right || rect.top >= rect.bottom;
}

// Checks count, ranges and y-monotonicity. On SELVAGE_OK *polygon refers to `vertices`.
[[nodiscard]] selvage_status examine(std::span<const selvage_vertex> vertices, Polygon* polygon);

}  // namespace selvage::mapper
