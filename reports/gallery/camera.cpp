#include "reports/gallery/camera.h"

#include <cmath>
#include <stdexcept>

namespace selvage::reports {

namespace {

constexpr double kRadiansPerDegree = 3.14159265358979323846 / 180;

selvage_vertex snap(double x_px, double y_px, double u_texel, double v_texel, double w,
                    double w_near) {
  selvage_vertex vertex{};
  const selvage_status status = selvage_snap(x_px, y_px, u_texel, v_texel, w, w_near, &vertex);
  if (status != SELVAGE_OK) throw std::runtime_error(selvage_status_text(status));
  return vertex;
}

}  // namespace

Point turned_about_x(const Point& p, double degree) {
  const double c = std::cos(degree * kRadiansPerDegree), s = std::sin(degree * kRadiansPerDegree);
  return {p.x, c * p.y - s * p.z, s * p.y + c * p.z};
}

Point turned_about_y(const Point& p, double degree) {
  const double c = std::cos(degree * kRadiansPerDegree), s = std::sin(degree * kRadiansPerDegree);
  return {c * p.x + s * p.z, p.y, c * p.z - s * p.x};
}

Point turned_about_z(const Point& p, double degree) {
  const double c = std::cos(degree * kRadiansPerDegree), s = std::sin(degree * kRadiansPerDegree);
  return {c * p.x - s * p.y, s * p.x + c * p.y, p.z};
}

selvage_vertex Camera::see(const Point& p, double u_texel, double v_texel) const {
  return snap(centre_x_px + focal_px * p.x / p.z, centre_y_px + focal_px * p.y / p.z, u_texel,
              v_texel, p.z, near_z);
}

selvage_vertex flat_vertex(double x_px, double y_px, double u_texel, double v_texel) {
  return snap(x_px, y_px, u_texel, v_texel, 1, 1);
}

}  // namespace selvage::reports
