// A floating-point DDA, affine or in perspective: x, u/w, v/w and 1/w stepped by additions down the
// two sides and along the span, one division a pixel. Real is float or double; every operation
// rounds to nearest.
//
//   vertices   x, y in px (exact), u q, v q in texels and q (each rounded once); equal q count as
//   1,
//              which spares the division
//   slopes     one division an edge and coordinate, one reciprocal of the width a span
//   prestep    to the first row's centre and to the span's first pixel's centre
//   texel      floor
#pragma once

#include "reports/stability/arithmetic.h"
#include "reports/stability/arithmetic_chain.h"
#include "reports/stability/arithmetic_floor.h"

namespace selvage::stability {

template <class Real>
struct Point {
  Real uq = 0, vq = 0, q = 0;

  friend Point operator+(const Point& a, const Point& b) {
    return {a.uq + b.uq, a.vq + b.vq, a.q + b.q};
  }
  friend Point operator-(const Point& a, const Point& b) {
    return {a.uq - b.uq, a.vq - b.vq, a.q - b.q};
  }
  friend Point operator*(const Point& a, Real factor) {
    return {a.uq * factor, a.vq * factor, a.q * factor};
  }
  friend Point operator/(const Point& a, Real divisor) {
    return {a.uq / divisor, a.vq / divisor, a.q / divisor};
  }
};

template <class Real, bool kAffine>
[[nodiscard]] Point<Real> point_of(const selvage_vertex& vertex) {
  constexpr Real subtexels = SELVAGE_SUBTEXELS;
  const Real q = kAffine ? 1 : static_cast<Real>(vertex.q);
  return {static_cast<Real>(vertex.u) / subtexels * q, static_cast<Real>(vertex.v) / subtexels * q,
          q};
}

template <class Real>
[[nodiscard]] Real px(int32_t fx8) {
  constexpr Real subpixels = SELVAGE_SUBPIXELS;
  return static_cast<Real>(fx8) / subpixels;
}

template <class Real>
[[nodiscard]] Real centre_px(int32_t index_px) {
  return static_cast<Real>(index_px) + Real(0.5);
}

template <class Real, bool kAffine>
class DdaEdge {
 public:
  DdaEdge() = default;
  DdaEdge(const selvage_vertex& top, const selvage_vertex& bottom, int32_t y_px) {
    const Real height = px<Real>(bottom.y) - px<Real>(top.y);
    const Real down = centre_px<Real>(y_px) - px<Real>(top.y);
    const Point<Real> from = point_of<Real, kAffine>(top);
    x_slope_ = (px<Real>(bottom.x) - px<Real>(top.x)) / height;
    slope_ = (point_of<Real, kAffine>(bottom) - from) / height;
    x = px<Real>(top.x) + x_slope_ * down;
    point = from + slope_ * down;
  }

  void step() {
    x += x_slope_;
    point = point + slope_;
  }

  Real x = 0;  // at the row's centre
  Point<Real> point;

 private:
  Real x_slope_ = 0;
  Point<Real> slope_;
};

// The first pixel whose centre is at or right of x.
template <class Real>
[[nodiscard]] int32_t first_centre(Real x_px) {
  return -floor_index(Real(0.5) - x_px);  // ceil(x - 1/2)
}

template <class Real, bool kAffine, class Pixels>
void draw_dda_span(const Call& call, const Pixels& pixels, int32_t y_px,
                   const DdaEdge<Real, kAffine>& left, const DdaEdge<Real, kAffine>& right) {
  const int32_t first = std::max(first_centre(left.x), call.visible.left);
  const int32_t end = std::min(first_centre(right.x), call.visible.right);
  if (first >= end) return;
  const Point<Real> step = (right.point - left.point) * (1 / (right.x - left.x));
  Point<Real> at = left.point + step * (centre_px<Real>(first) - left.x);
  char* row = pixels.row(y_px);
  for (int32_t x = first; x < end; ++x, at = at + step) {
    const Real w = kAffine ? 1 : 1 / at.q;
    pixels.copy(row, x, floor_index(at.uq * w), floor_index(at.vq * w));
  }
}

template <class Real, bool kAffine, class Pixels>
void draw_dda_rows(const Call& call, const Pixels& pixels) {
  using Edge = DdaEdge<Real, kAffine>;
  for_each_row<Edge>(call, [&](int32_t y_px, const Edge& a, const Edge& b) {
    const bool a_is_left = a.x <= b.x;
    draw_dda_span<Real, kAffine>(call, pixels, y_px, a_is_left ? a : b, a_is_left ? b : a);
  });
}

template <class Real>
selvage_status draw_dda(const selvage_image* target, const selvage_rect* clip,
                        const selvage_vertex* vertices, size_t count,
                        const selvage_texture* texture, const selvage_options* options) {
  return draw_checked(target, clip, vertices, count, texture, options,
                      [](const Call& call, const auto& pixels) {
                        if (call.affine)
                          draw_dda_rows<Real, true>(call, pixels);
                        else
                          draw_dda_rows<Real, false>(call, pixels);
                      });
}

}  // namespace selvage::stability
