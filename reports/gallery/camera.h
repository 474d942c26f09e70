// A pinhole camera: points of space to vertices.
#pragma once

#include "selvage.h"

namespace selvage::reports {

// Space: x right, y down, z away from the eye, any unit.
struct Point {
  double x = 0, y = 0, z = 0;
};

[[nodiscard]] Point turned_about_x(const Point& p, double degree);
[[nodiscard]] Point turned_about_y(const Point& p, double degree);
[[nodiscard]] Point turned_about_z(const Point& p, double degree);

struct Camera {
  double centre_x_px = 240, centre_y_px = 150;
  double focal_px = 400;
  double near_z = 1;  // no point drawn is nearer

  // The vertex of a point with its texture coordinates. Throws std::runtime_error where
  // selvage_snap refuses it.
  [[nodiscard]] selvage_vertex see(const Point& p, double u_texel, double v_texel) const;
};

// A vertex of a flat drawing. Throws like Camera::see.
[[nodiscard]] selvage_vertex flat_vertex(double x_px, double y_px, double u_texel, double v_texel);

}  // namespace selvage::reports
