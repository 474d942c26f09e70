// The map of a polygon as three planes over the target, in double: what a plain mapper steps along
// and what OpenCV wants as a matrix. For polygons whose map is affine or projective throughout.
#pragma once

#include <span>

#include "selvage.h"

namespace selvage::reports {

// value(x, y) = dx * x + dy * y + origin, x and y in px.
struct Plane {
  double dx = 0, dy = 0, origin = 0;
  [[nodiscard]] double at(double x_px, double y_px) const { return dx * x_px + dy * y_px + origin; }
};

struct Planes {
  Plane u, v, q;  // u * q and v * q in texels, and q, with q scaled to 1 at the first vertex
  bool affine = true;
};

// From the first, the second and the last vertex, which must not be collinear.
[[nodiscard]] Planes planes_of(std::span<const selvage_vertex> polygon);

}  // namespace selvage::reports
