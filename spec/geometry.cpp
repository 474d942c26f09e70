#include "spec/geometry.h"

#include <algorithm>

namespace selvage::spec {

int64_t doubled_area(Point a, Point b, Point c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

int64_t doubled_area(std::span<const selvage_vertex> outline) {
  int64_t sum = 0;
  for (size_t i = 0; i < outline.size(); ++i) {
    const selvage_vertex &a = outline[i], &b = outline[(i + 1) % outline.size()];
    sum += int64_t{a.x} * b.y - int64_t{b.x} * a.y;
  }
  return sum;
}

bool on_segment(Point p, Point a, Point b) {
  return doubled_area(a, b, p) == 0 && std::min(a.x, b.x) <= p.x && p.x <= std::max(a.x, b.x) &&
         std::min(a.y, b.y) <= p.y && p.y <= std::max(a.y, b.y);
}

bool on_outline(Point p, std::span<const selvage_vertex> outline) {
  for (size_t i = 0; i < outline.size(); ++i) {
    const selvage_vertex& next = outline[(i + 1) % outline.size()];
    if (on_segment(p, position(outline[i]), position(next))) return true;
  }
  return false;
}

int winding_number(Point p, std::span<const selvage_vertex> outline) {
  int winding = 0;
  for (size_t i = 0; i < outline.size(); ++i) {
    const Point a = position(outline[i]);
    const Point b = position(outline[(i + 1) % outline.size()]);
    const bool down = a.y <= p.y && p.y < b.y;
    const bool up = b.y <= p.y && p.y < a.y;
    if (!down && !up) continue;
    // Seen along a downward edge, what is at or right of it has a doubled area of at most 0.
    const int64_t side = down ? doubled_area(a, b, p) : doubled_area(b, a, p);
    if (side <= 0) winding += up ? 1 : -1;
  }
  return winding;
}

std::vector<selvage_vertex> convex_hull(std::span<const selvage_vertex> points) {
  std::vector<selvage_vertex> sorted(points.begin(), points.end());
  const auto key = [](const selvage_vertex& v) { return std::pair(v.x, v.y); };
  std::ranges::stable_sort(sorted, {}, key);
  const auto repeated = std::ranges::unique(sorted, {}, key);
  sorted.erase(repeated.begin(), repeated.end());
  if (sorted.size() < 3) return sorted;

  // Andrew's monotone chain: the upper hull from left to right, then the lower one back.
  std::vector<selvage_vertex> hull;
  const auto extend = [&hull](const selvage_vertex& v, size_t keep) {
    while (hull.size() > keep &&
           doubled_area(position(hull[hull.size() - 2]), position(hull.back()), position(v)) <= 0) {
      hull.pop_back();
    }
    hull.push_back(v);
  };
  for (const selvage_vertex& v : sorted) extend(v, 1);
  const size_t upper = hull.size();
  for (size_t i = sorted.size() - 1; i-- > 0;) extend(sorted[i], upper);
  hull.pop_back();
  return hull;
}

}  // namespace selvage::spec
