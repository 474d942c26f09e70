// Float, triangles by planes: a x + b y + c is evaluated at each pixel centre, nothing is stepped.
// Every operation rounds to nearest, 24 bits.
//
//   coverage   three edge functions, in by the top-left rule on ties. Negating every input negates
//              every rounded result, so the two sides of an edge are exact opposites: a rounding
//              moves an edge, but tears nothing
//   u/w, v/w, 1/w   planes through the three vertices; equal q count as 1, which spares the
//              division a pixel
//   texel      floor
//
// An n-gon is a fan from its vertex 0: right for convex outlines only, and another map than the
// edge-ruled one where outline and texture polygon are not related by one affine or projective map.
#include <algorithm>
#include <array>
#include <utility>

#include "reports/stability/arithmetic.h"
#include "reports/stability/arithmetic_chain.h"
#include "reports/stability/arithmetic_floor.h"

namespace selvage::stability {
namespace {

struct Plane {
  float a = 0, b = 0, c = 0;
  // The part that a row's pixels share.
  [[nodiscard]] float row(float y_px) const { return b * y_px + c; }
  [[nodiscard]] float at(float x_px, float row) const { return a * x_px + row; }
};

struct Corner {
  float x, y;       // px
  float uq, vq, q;  // texels
};

using Triangle = std::array<Corner, 3>;  // clockwise on screen

[[nodiscard]] Corner corner_of(const selvage_vertex& vertex, bool affine) {
  constexpr float subpixels = SELVAGE_SUBPIXELS, subtexels = SELVAGE_SUBTEXELS;
  const float q = affine ? 1 : static_cast<float>(vertex.q);
  return {static_cast<float>(vertex.x) / subpixels, static_cast<float>(vertex.y) / subpixels,
          static_cast<float>(vertex.u) / subtexels * q,
          static_cast<float>(vertex.v) / subtexels * q, q};
}

// Twice the area, positive where clockwise on screen.
[[nodiscard]] float area(const Triangle& t) {
  return (t[1].x - t[0].x) * (t[2].y - t[0].y) - (t[2].x - t[0].x) * (t[1].y - t[0].y);
}

class EdgeFunction {
 public:
  EdgeFunction(const Corner& from, const Corner& to)
      : plane_{from.y - to.y, to.x - from.x, from.x * to.y - to.x * from.y},
        owns_ties_(plane_.a > 0 || (plane_.a == 0 && plane_.b > 0)) {}  // a left or a top edge

  void start_row(float y_px) { row_ = plane_.row(y_px); }
  [[nodiscard]] bool holds(float x_px) const {
    const float side = plane_.at(x_px, row_);
    return side > 0 || (side == 0 && owns_ties_);
  }

 private:
  Plane plane_;
  bool owns_ties_;
  float row_ = 0;
};

[[nodiscard]] Plane plane_through(const Triangle& t, float Corner::*value) {
  const float d1 = t[1].*value - t[0].*value, d2 = t[2].*value - t[0].*value;
  const float x1 = t[1].x - t[0].x, y1 = t[1].y - t[0].y;
  const float x2 = t[2].x - t[0].x, y2 = t[2].y - t[0].y;
  Plane plane;
  plane.a = (d1 * y2 - d2 * y1) / area(t);
  plane.b = (d2 * x1 - d1 * x2) / area(t);
  plane.c = t[0].*value - plane.a * t[0].x - plane.b * t[0].y;
  return plane;
}

// The centres that the triangle's bounding box and the window hold.
[[nodiscard]] selvage_rect box_of(const std::array<selvage_vertex, 3>& t,
                                  const selvage_rect& visible) {
  const auto [left, right] = std::minmax({t[0].x, t[1].x, t[2].x});
  const auto [top, bottom] = std::minmax({t[0].y, t[1].y, t[2].y});
  return {std::max(first_centre_px(left), visible.left),
          std::max(first_centre_px(top), visible.top),
          std::min(first_centre_px(right), visible.right),
          std::min(first_centre_px(bottom), visible.bottom)};
}

template <bool kAffine, class Pixels>
void draw_triangle(const Pixels& pixels, const Triangle& t, const selvage_rect& box) {
  std::array edges{EdgeFunction(t[0], t[1]), EdgeFunction(t[1], t[2]), EdgeFunction(t[2], t[0])};
  const Plane uq = plane_through(t, &Corner::uq), vq = plane_through(t, &Corner::vq);
  const Plane q = plane_through(t, &Corner::q);
  for (int32_t y = box.top; y < box.bottom; ++y) {
    const float y_px = static_cast<float>(y) + 0.5f;
    for (EdgeFunction& edge : edges) edge.start_row(y_px);
    const float uq_row = uq.row(y_px), vq_row = vq.row(y_px), q_row = q.row(y_px);
    char* row = pixels.row(y);
    const auto holds = [&](int32_t x) {
      const float x_px = static_cast<float>(x) + 0.5f;
      return edges[0].holds(x_px) && edges[1].holds(x_px) && edges[2].holds(x_px);
    };
    // Rounding keeps order, so what an edge holds of a row is in one piece.
    int32_t x = box.left;
    while (x < box.right && !holds(x)) ++x;
    for (; x < box.right && holds(x); ++x) {
      const float x_px = static_cast<float>(x) + 0.5f;
      const float w = kAffine ? 1 : 1 / q.at(x_px, q_row);
      pixels.copy(row, x, floor_index(uq.at(x_px, uq_row) * w),
                  floor_index(vq.at(x_px, vq_row) * w));
    }
  }
}

template <bool kAffine, class Pixels>
void draw_fan(const Call& call, const Pixels& pixels) {
  for (size_t i = 2; i < call.outline.size(); ++i) {
    const std::array corners{call.outline[0], call.outline[i - 1], call.outline[i]};
    Triangle t{corner_of(corners[0], kAffine), corner_of(corners[1], kAffine),
               corner_of(corners[2], kAffine)};
    if (area(t) == 0) continue;
    if (area(t) < 0) std::swap(t[1], t[2]);
    draw_triangle<kAffine>(pixels, t, box_of(corners, call.visible));
  }
}

selvage_status draw_planes(const selvage_image* target, const selvage_rect* clip,
                           const selvage_vertex* vertices, size_t count,
                           const selvage_texture* texture, const selvage_options* options) {
  return draw_checked(target, clip, vertices, count, texture, options,
                      [](const Call& call, const auto& pixels) {
                        if (call.affine)
                          draw_fan<true>(call, pixels);
                        else
                          draw_fan<false>(call, pixels);
                      });
}

}  // namespace

Arithmetic float32_plane() {
  return {"float32-plane",
          "float, 24 bits: edge functions and planes of u/w, v/w, 1/w evaluated at each pixel, a "
          "division a pixel; floor; n-gons as a fan of triangles",
          false, draw_planes};
}

}  // namespace selvage::stability
