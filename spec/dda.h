// The arithmetic of the historic profiles, closed: each pixel's texel from a formula of its own.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "spec/exact.h"
#include "spec/historic_line.h"

namespace selvage::spec {

// The texel, not yet addressed, of column x_px; empty if it is not covered.
//
//   abrash56   W = right column - left column, k = x - left column
//              step = (u_right - u_left) / W, toward zero        s = floor(u_left + k step)
//   abrash57   the same step              s = floor(u_left + floor(step / 2) + k step + 1/2)
//   dkit       W as above                 s = floor(T_left + k (T_right - T_left) / W + 1/2)
[[nodiscard]] std::optional<Texel> dda_texel(const HistoricLine& line, int32_t x_px);

// The shift (ds, dt) by which abrash57 copies a rectangle of as many texel centres as pixels: all
// edges but horizontal ones run up at x = left, u = left + ds or down at x = right, u = right - 1 +
// ds, and v goes from top + dt to bottom - 1 + dt in proportion. Empty for every other outline.
[[nodiscard]] std::optional<Texel> centred_block_shift(std::span<const selvage_vertex> vertices);

}  // namespace selvage::spec
