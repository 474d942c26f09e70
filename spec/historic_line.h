// A scan line of a historic profile: where its two edges are, exactly and as the profile rounds.
//
// Each value is computed on its own from the edge's two vertices; nothing is stepped.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "spec/exact.h"

namespace selvage::spec {

// One edge where it meets the scan line.
struct HistoricEnd {
  Rational x;              // px, exact
  Rational u, v;           // texels, exact; half a row further down where the profile presteps
  int32_t column_px;       // ceil(x); dkit: floor(x + 1/2)
  int64_t u_fx16, v_fx16;  // as the profile's arithmetic has them; dkit: whole texels
  int32_t rows;            // walked down the edge
};

// abrash56, abrash57: the left end is on the edge that runs up, the right one on the edge that runs
// down. dkit: the left end is the lesser one by column, u and v.
struct HistoricLine {
  selvage_profile profile;
  HistoricEnd left, right;

  // Columns [left.column_px, end_px) are covered; none if that is empty.
  [[nodiscard]] int32_t end_px() const {
    return right.column_px + (profile == SELVAGE_PROFILE_DKIT ? 1 : 0);
  }
  [[nodiscard]] bool covers(int32_t x_px) const {
    return left.column_px <= x_px && x_px < end_px();
  }
};

// Row y_px of a valid outline; empty if it crosses no edge.
[[nodiscard]] std::optional<HistoricLine> historic_line(selvage_profile profile,
                                                        std::span<const selvage_vertex> vertices,
                                                        int32_t y_px);

// The source divides 16.16 numbers toward zero.
[[nodiscard]] constexpr int64_t truncated_quotient(int64_t a, int64_t b) { return a / b; }
// The largest whole number not above half of a.
[[nodiscard]] constexpr int64_t floor_half(int64_t a) {
  return (a - (a % 2 != 0 && a < 0 ? 1 : 0)) / 2;
}

}  // namespace selvage::spec
