#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "scene/plan.h"
#include "scene/ruled_footprint.h"

namespace selvage::scene {
namespace {

// u q (or v q) and q on the screen, linear in x and y: values at corners and their slopes a pixel.
struct Linear {
  double along_x = 0, along_y = 0;
};

struct Triangle {
  const selvage_vertex *a = nullptr, *b = nullptr, *c = nullptr;
  double doubled_area_px = 0;
};

[[nodiscard]] double doubled_area_px(const selvage_vertex& a, const selvage_vertex& b,
                                     const selvage_vertex& c) {
  const int64_t area = int64_t{b.x - a.x} * (c.y - a.y) - int64_t{c.x - a.x} * (b.y - a.y);
  return static_cast<double>(area) / (kSubpixels * kSubpixels);
}

[[nodiscard]] Triangle largest_triangle(std::span<const selvage_vertex> vertices) {
  Triangle largest;
  for (size_t i = 0; i < vertices.size(); ++i) {
    for (size_t j = i + 1; j < vertices.size(); ++j) {
      for (size_t k = j + 1; k < vertices.size(); ++k) {
        const double area = doubled_area_px(vertices[i], vertices[j], vertices[k]);
        if (std::abs(area) > std::abs(largest.doubled_area_px)) {
          largest = {&vertices[i], &vertices[j], &vertices[k], area};
        }
      }
    }
  }
  return largest;
}

template <class Value>
[[nodiscard]] Linear slopes(const Triangle& t, Value value) {
  const double b = value(*t.b) - value(*t.a), c = value(*t.c) - value(*t.a);
  const auto px = [](int32_t fx8) { return fx8 / kSubpixels; };
  const double bx = px(t.b->x - t.a->x), by = px(t.b->y - t.a->y);
  const double cx = px(t.c->x - t.a->x), cy = px(t.c->y - t.a->y);
  return {(b * cy - c * by) / t.doubled_area_px, (c * bx - b * cx) / t.doubled_area_px};
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
[[nodiscard]] double bound_of(std::span<const selvage_vertex> vertices, const Triangle& triangle,
                              int32_t selvage_vertex::*coordinate) {
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
  for (const selvage_vertex& a : vertices) {
    for (const selvage_vertex& b : vertices) {
      bound = std::max(
          bound, greatest_quotient(numerator(a), numerator(b) - numerator(a), q(a), q(b) - q(a)));
    }
  }
  return bound;
}

}  // namespace

double texels_per_px_bound(std::span<const selvage_vertex> vertices) {
  if (vertices.size() > 3) return ruled_texels_per_px_bound(vertices);
  const Triangle triangle = largest_triangle(vertices);
  if (triangle.a == nullptr) return std::numeric_limits<double>::infinity();
  return std::max(bound_of(vertices, triangle, &selvage_vertex::u),
                  bound_of(vertices, triangle, &selvage_vertex::v)) *
         (1 + 0x1p-20);  // holds the roundings, which cancellation may enlarge
}

}  // namespace selvage::scene
