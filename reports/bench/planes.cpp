#include "reports/bench/planes.h"

#include <array>

#include "spec/vertex_units.h"

namespace selvage::reports {

namespace {

using spec::kPixel_fx8;
using spec::kTexel_fx16;

struct Point {
  double x_px, y_px;
};

Plane through(const std::array<Point, 3>& p, double a, double b, double c) {
  const double x1 = p[1].x_px - p[0].x_px, y1 = p[1].y_px - p[0].y_px;
  const double x2 = p[2].x_px - p[0].x_px, y2 = p[2].y_px - p[0].y_px;
  const double area = x1 * y2 - x2 * y1;
  Plane plane;
  plane.dx = ((b - a) * y2 - (c - a) * y1) / area;
  plane.dy = ((c - a) * x1 - (b - a) * x2) / area;
  plane.origin = a - plane.dx * p[0].x_px - plane.dy * p[0].y_px;
  return plane;
}

}  // namespace

Planes planes_of(std::span<const selvage_vertex> polygon) {
  const std::array<selvage_vertex, 3> corner{polygon[0], polygon[1], polygon.back()};
  std::array<Point, 3> p{};
  std::array<double, 3> u{}, v{}, q{};
  for (size_t i = 0; i < 3; ++i) {
    p[i] = {static_cast<double>(corner[i].x) / kPixel_fx8,
            static_cast<double>(corner[i].y) / kPixel_fx8};
    q[i] = static_cast<double>(corner[i].q) / corner[0].q;
    u[i] = static_cast<double>(corner[i].u) / kTexel_fx16 * q[i];
    v[i] = static_cast<double>(corner[i].v) / kTexel_fx16 * q[i];
  }
  Planes planes;
  planes.affine = corner[0].q == corner[1].q && corner[0].q == corner[2].q;
  planes.u = through(p, u[0], u[1], u[2]);
  planes.v = through(p, v[0], v[1], v[2]);
  planes.q = through(p, q[0], q[1], q[2]);
  return planes;
}

}  // namespace selvage::reports
