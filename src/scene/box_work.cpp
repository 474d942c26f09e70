#include "scene/box_work.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "scene/screen_face.h"

namespace selvage::scene {
namespace {

// All but x and y is linear on the screen.
struct Point {
  double x_px, y_px, uq, vq, q;
};

[[nodiscard]] Point between(const Point& a, const Point& b, double t) {
  const auto mix = [t](double from, double to) { return from + t * (to - from); };
  return {mix(a.x_px, b.x_px), mix(a.y_px, b.y_px), mix(a.uq, b.uq), mix(a.vq, b.vq),
          mix(a.q, b.q)};
}

[[nodiscard]] std::vector<Point> outline(std::span<const selvage_vertex> vertices) {
  std::vector<Point> points;
  for (const selvage_vertex& p : vertices) {
    points.push_back({p.x / kSubpixels, p.y / kSubpixels, p.u / kSubtexels * p.q,
                      p.v / kSubtexels * p.q, static_cast<double>(p.q)});
  }
  return points;
}

// What of a polygon is on the side where inside(point) >= 0.
template <class Inside>
[[nodiscard]] std::vector<Point> cut(const std::vector<Point>& points, const Inside& inside) {
  std::vector<Point> left;
  for (size_t i = 0; i < points.size(); ++i) {
    const Point &a = points[i], &b = points[(i + 1) % points.size()];
    const double of_a = inside(a), of_b = inside(b);
    if (of_a >= 0) left.push_back(a);
    if ((of_a >= 0) != (of_b >= 0)) left.push_back(between(a, b, of_a / (of_a - of_b)));
  }
  return left;
}

[[nodiscard]] std::vector<Point> cut(std::vector<Point> points, const selvage_rect& clip) {
  points = cut(points, [&](const Point& p) { return p.x_px - clip.left; });
  points = cut(points, [&](const Point& p) { return clip.right - p.x_px; });
  points = cut(points, [&](const Point& p) { return p.y_px - clip.top; });
  return cut(points, [&](const Point& p) { return clip.bottom - p.y_px; });
}

struct Triangle {
  Point a, b, c;

  [[nodiscard]] double doubled_area_px() const {
    return (b.x_px - a.x_px) * (c.y_px - a.y_px) - (c.x_px - a.x_px) * (b.y_px - a.y_px);
  }
};

// |du/dx| + |du/dy| at a point, and a texel, for a box takes parts of its first and its last; at
// most all of the texture, which repeats beyond, or whose edge is counted and not visited.
[[nodiscard]] double side_texel(const Triangle& t, const Point& at, double Point::*uq,
                                int32_t size_texel) {
  const auto change = [&](const Point& p, const Point& from) {
    return p.*uq - from.*uq - at.*uq / at.q * (p.q - from.q);
  };
  const double b = change(t.b, t.a), c = change(t.c, t.a);
  const double along_x = b * (t.c.y_px - t.a.y_px) - c * (t.b.y_px - t.a.y_px);
  const double along_y = c * (t.b.x_px - t.a.x_px) - b * (t.c.x_px - t.a.x_px);
  const double side =
      (std::abs(along_x) + std::abs(along_y)) / (std::abs(t.doubled_area_px()) * at.q);
  return std::min(side + 1, static_cast<double>(size_texel));
}

// The mean over a triangle, by the middles of its sides, which is right for what is quadratic.
[[nodiscard]] double spared_per_px(const TextureImage& image, const Triangle& t) {
  double sum = 0;
  for (const Point& at : {between(t.a, t.b, 0.5), between(t.b, t.c, 0.5), between(t.c, t.a, 0.5)}) {
    const double texels = side_texel(t, at, &Point::uq, image.width_texel) *
                          side_texel(t, at, &Point::vq, image.height_texel);
    sum += std::max(texels - kLookingUp_texels, 0.0);
  }
  return sum / 3;
}

}  // namespace

double spared_texels(const TextureImage& image, std::span<const selvage_vertex> vertices,
                     const selvage_options& options, const selvage_rect& clip) {
  if (options.filter != SELVAGE_FILTER_AREA) return 0;
  const std::vector<Point> seen = cut(outline(vertices), clip);
  double sum = 0;
  for (size_t i = 2; i < seen.size(); ++i) {
    const Triangle triangle{seen[0], seen[i - 1], seen[i]};
    const double area_px = std::abs(triangle.doubled_area_px()) / 2;
    if (area_px > 0) sum += area_px * spared_per_px(image, triangle);
  }
  return sum;
}

}  // namespace selvage::scene
