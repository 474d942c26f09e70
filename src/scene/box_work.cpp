#include "scene/box_work.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "scene/slopes.h"

namespace selvage::scene {
namespace {

// u q and q at a point, and how they change.
struct Coordinate {
  double uq;
  Linear slopes_uq;
};

// |du/dx| + |du/dy| and a texel, for a box takes parts of its first and its last; at most all of
// the texture, which repeats beyond, or whose edge is counted and not visited.
[[nodiscard]] double side_texel(const Coordinate& c, double q, const Linear& slopes_q,
                                int32_t size_texel) {
  const double u = c.uq / q;
  const double side = (std::abs(c.slopes_uq.along_x - u * slopes_q.along_x) +
                       std::abs(c.slopes_uq.along_y - u * slopes_q.along_y)) /
                      q;
  return std::min(side + 1, static_cast<double>(size_texel));
}

// The mean over a triangle, by the middles of its sides, which is right for what is quadratic.
[[nodiscard]] double spared_per_px(const TextureImage& image, Triangle triangle) {
  const auto q = [](const selvage_vertex& p) { return static_cast<double>(p.q); };
  const auto uq = [&](const selvage_vertex& p) { return p.u / kSubtexels * q(p); };
  const auto vq = [&](const selvage_vertex& p) { return p.v / kSubtexels * q(p); };
  const Linear slopes_q = slopes(triangle, q);
  const Linear slopes_uq = slopes(triangle, uq), slopes_vq = slopes(triangle, vq);
  double sum = 0;
  for (size_t i = 0; i < 3; ++i) {
    const selvage_vertex &a = triangle[i], &b = triangle[(i + 1) % 3];
    const auto middle = [&](const auto& of) { return (of(a) + of(b)) / 2; };
    const double columns =
        side_texel({middle(uq), slopes_uq}, middle(q), slopes_q, image.width_texel);
    const double rows =
        side_texel({middle(vq), slopes_vq}, middle(q), slopes_q, image.height_texel);
    sum += std::max(columns * rows - kLookingUp_texels, 0.0);
  }
  return sum / 3;
}

// Of the vertices' bounding box, the share within the clip rectangle.
[[nodiscard]] double share_within(const selvage_rect& clip,
                                  std::span<const selvage_vertex> vertices) {
  const auto share = [&](int32_t selvage_vertex::*of, int32_t first_px, int32_t end_px) {
    const auto [least, most] =
        std::ranges::minmax_element(vertices, {}, [&](const auto& vertex) { return vertex.*of; });
    const double low = px((*least).*of), high = px((*most).*of);
    const double within = std::min<double>(high, end_px) - std::max<double>(low, first_px);
    return high > low ? std::clamp(within / (high - low), 0.0, 1.0) : 0;
  };
  return share(&selvage_vertex::x, clip.left, clip.right) *
         share(&selvage_vertex::y, clip.top, clip.bottom);
}

}  // namespace

double spared_texels(const TextureImage& image, std::span<const selvage_vertex> vertices,
                     const selvage_options& options, const selvage_rect& clip) {
  if (options.filter != SELVAGE_FILTER_AREA) return 0;
  double sum = 0;
  for (size_t i = 2; i < vertices.size(); ++i) {
    const std::array corners{vertices[0], vertices[i - 1], vertices[i]};
    const double area_px = std::abs(doubled_area_px(corners)) / 2;
    if (area_px > 0) sum += area_px * spared_per_px(image, corners);
  }
  return sum * share_within(clip, vertices);
}

}  // namespace selvage::scene
