#include <algorithm>
#include <cmath>
#include <limits>

#include "scene/plan.h"
#include "scene/ruled_footprint.h"
#include "scene/screen_face.h"

namespace selvage::scene {
namespace {

// u q (or v q) and q on the screen, linear in x and y: values at corners and their slopes a pixel.
struct Linear {
  double along_x = 0, along_y = 0;
};

using ScreenTriangle = std::span<const selvage_vertex, 3>;

[[nodiscard]] double doubled_area_px(ScreenTriangle t) {
  return to_px(t[1].x - t[0].x) * to_px(t[2].y - t[0].y) -
         to_px(t[2].x - t[0].x) * to_px(t[1].y - t[0].y);
}

template <class Value>
[[nodiscard]] Linear slopes(ScreenTriangle t, Value value) {
  const double b = value(t[1]) - value(t[0]), c = value(t[2]) - value(t[0]);
  const double bx = to_px(t[1].x - t[0].x), by = to_px(t[1].y - t[0].y);
  const double cx = to_px(t[2].x - t[0].x), cy = to_px(t[2].y - t[0].y);
  const double area_px = doubled_area_px(t);
  return {(b * cy - c * by) / area_px, (c * bx - b * cx) / area_px};
}

// The greatest of (a + b t) / (c + d t)^2 for t in [0, 1], a, a + b >= 0 and c, c + d > 0: at an
// end, or where the derivative vanishes.
[[nodiscard]] double greatest_quotient(double a, double b, double c, double d) {
  const auto at = [&](double t) { return (a + b * t) / ((c + d * t) * (c + d * t)); };
  const double ends = std::max(at(0), at(1));
  const double level = (b * c - 2 * a * d) / (b * d);
  return level > 0 && level < 1 ? std::max(ends, at(level)) : ends;
}

// du/dx = (U_x q - U q_x) / q^2 with U = u q. The numerator is linear on the screen, so the sum of
// the two magnitudes is at most the mean of its values at the corners, weighted as q is; and of all
// such weights with one q those of two corners give the greatest.
[[nodiscard]] double bound_of(ScreenTriangle triangle, int32_t selvage_vertex::*coordinate) {
  const auto q = [](const selvage_vertex& vertex) { return static_cast<double>(vertex.q); };
  const auto texel = [&](const selvage_vertex& vertex) { return vertex.*coordinate / kSubtexels; };
  const Linear q_slopes = slopes(triangle, q);
  const Linear uq_slopes =
      slopes(triangle, [&](const auto& vertex) { return texel(vertex) * q(vertex); });
  const auto numerator = [&](const selvage_vertex& p) {
    return std::abs(uq_slopes.along_x * q(p) - texel(p) * q(p) * q_slopes.along_x) +
           std::abs(uq_slopes.along_y * q(p) - texel(p) * q(p) * q_slopes.along_y);
  };
  double bound = 0;
  for (const selvage_vertex& a : triangle) {
    for (const selvage_vertex& b : triangle) {
      bound = std::max(
          bound, greatest_quotient(numerator(a), numerator(b) - numerator(a), q(a), q(b) - q(a)));
    }
  }
  return bound;
}

}  // namespace

double texels_per_px_bound(std::span<const selvage_vertex> vertices) {
  if (vertices.size() != 3) return ruled_texels_per_px_bound(vertices);
  const ScreenTriangle triangle = vertices.first<3>();
  if (doubled_area_px(triangle) == 0) return std::numeric_limits<double>::infinity();
  return std::max(bound_of(triangle, &selvage_vertex::u), bound_of(triangle, &selvage_vertex::v)) *
         kFootprintSlack;
}

}  // namespace selvage::scene
