// Integer geometry on outlines, exact: winding, convex hulls, points on edges.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "selvage.h"

namespace selvage::spec {

struct Point {
  int64_t x, y;  // 1/256 px
  friend bool operator==(const Point&, const Point&) = default;
};

struct Pixel {
  int32_t x_px, y_px;
};

[[nodiscard]] inline Point position(const selvage_vertex& v) { return {v.x, v.y}; }
[[nodiscard]] inline Point pixel_centre(int32_t x_px, int32_t y_px) {
  return {int64_t{x_px} * SELVAGE_SUBPIXELS + SELVAGE_SUBPIXELS / 2,
          int64_t{y_px} * SELVAGE_SUBPIXELS + SELVAGE_SUBPIXELS / 2};
}

// Twice the signed area of a triangle: positive when a, b, c run clockwise on the screen (y down).
[[nodiscard]] int64_t doubled_area(Point a, Point b, Point c);
// Likewise of an outline, as often as it goes round. Below 2 * 256 vertices * 2^48.
[[nodiscard]] int64_t doubled_area(std::span<const selvage_vertex> outline);

// The point lies on the closed segment.
[[nodiscard]] bool on_segment(Point p, Point a, Point b);
[[nodiscard]] bool on_outline(Point p, std::span<const selvage_vertex> outline);

// How often the outline runs clockwise around the sample point p, under the half-open rule: edges
// from below to above count +1, from above to below -1, where y_top <= p.y < y_bottom and the edge
// is at or left of p.
[[nodiscard]] int winding_number(Point p, std::span<const selvage_vertex> outline);

// The vertices on the corners of the convex hull, clockwise on the screen; fewer than 3 if the
// points lie on a line. Of several vertices at one place the first is taken.
[[nodiscard]] std::vector<selvage_vertex> convex_hull(std::span<const selvage_vertex> points);

}  // namespace selvage::spec
