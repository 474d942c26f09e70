#include "reports/gallery/shapes.h"

#include <cmath>
#include <numbers>

#include "reports/gallery/camera.h"

namespace selvage::reports {

namespace {

constexpr double kDistance = 4;

}  // namespace

Grid globe(const GlobeView& view, const cli::Raster& map) {
  // The outline of a unit sphere at a distance d has the tangent 1 / sqrt(d^2 - 1).
  const Camera camera{view.centre_x_px, view.centre_y_px,
                      view.radius_px * std::sqrt(kDistance * kDistance - 1), kDistance - 1.01};
  return make_grid(view.columns, view.rows, [&](double across, double down) {
    const double longitude = (across - 0.5) * 2 * std::numbers::pi,
                 latitude = (0.5 - down) * std::numbers::pi;
    Point p{std::cos(latitude) * std::sin(longitude), -std::sin(latitude),
            -std::cos(latitude) * std::cos(longitude)};
    p = turned_about_y(p, view.east_degree);
    p = turned_about_x(p, view.north_degree);
    p = turned_about_z(p, view.roll_degree);
    p.z += kDistance;
    return camera.see(p, across * map.width_px, down * map.height_px);
  });
}

Grid wave(const WaveView& view, const cli::Raster& picture) {
  const Camera camera{view.centre_x_px, view.centre_y_px, view.focal_px, 0.5};
  return make_grid(view.columns, view.rows, [&](double across, double down) {
    const double x = (across - 0.5) * view.width, y = (down - 0.5) * view.height;
    Point p{x, y, view.amplitude * std::sin(2.4 * x + 1.1 * y) * std::cos(1.3 * y - 0.4 * x)};
    p = turned_about_x(p, -view.pitch_degree);
    p = turned_about_y(p, view.yaw_degree);
    p = turned_about_z(p, view.roll_degree);
    p.z += kDistance;
    return camera.see(p, across * picture.width_px, down * picture.height_px);
  });
}

}  // namespace selvage::reports
