// How far a historic profile may be from the exact map: derived, pixel by pixel, never flat.
//
// Three causes, each with its own part (spec/proofs has their proofs):
//   rounding        the 16.16 steps: so many units for each row walked down an edge and each pixel
//                   walked along the span; dkit instead rounds the edges' texels by half a texel
//   whole columns   the span is walked in whole columns although its edges are not: a position
//                   error of e px, so e |du/dx| texels, but never more than the span's own change
//   sampling        abrash57 presteps half a row: its exact map is taken there (historic_line.h)
#pragma once

#include <cstdint>
#include <optional>

#include "spec/case.h"
#include "spec/exact.h"
#include "spec/historic_line.h"

namespace selvage::spec {

// The exact coordinates at a pixel's sample point, and the interval that the arithmetic may reach:
// [u - u_below, u + u_above] before the texel is taken, likewise v.
struct Reach {
  Rational u, v;
  Rational u_below, u_above, v_below, v_above;
};

// Empty where the line does not cover column x_px.
[[nodiscard]] std::optional<Reach> reach(const HistoricLine& line, int32_t x_px);
// The same for a valid case of a historic profile; clip and target do not matter.
[[nodiscard]] std::optional<Reach> reach(const Case& c, int32_t x_px, int32_t y_px);

}  // namespace selvage::spec
