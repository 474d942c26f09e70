// How fast the coordinates change at a pixel: the partial derivatives of the map of section 4.
#pragma once

#include <optional>
#include <span>

#include "spec/exact.h"

namespace selvage::spec {

// Texels per pixel, at the pixel's centre.
struct Gradient {
  Rational u_along_x, u_along_y, v_along_x, v_along_y;
};

// Of the map that is ruled by the two edges that cross the pixel's row, taken as straight lines
// that go on. Empty if the pixel is not covered. The outline must be y-monotone.
[[nodiscard]] std::optional<Gradient> gradient(std::span<const selvage_vertex> vertices,
                                               int32_t x_px, int32_t y_px);

}  // namespace selvage::spec
