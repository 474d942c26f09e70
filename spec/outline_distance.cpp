#include "spec/outline_distance.h"

#include <algorithm>
#include <cstdlib>

namespace selvage::spec {
namespace {

inline constexpr int64_t kFx16PerFx8 = 256;

template <class Number>
[[nodiscard]] Number to(int64_t whole) {
  return Number(static_cast<long>(whole));
}

// An edge as seen from a point: a + t (b - a), 0 <= t <= 1.
struct Edge {
  Point a, step;

  Edge(Point p, const selvage_vertex& from, const selvage_vertex& to)
      : a{from.x - p.x, from.y - p.y}, step{int64_t{to.x} - from.x, int64_t{to.y} - from.y} {}

  template <class Number>
  [[nodiscard]] Number distance_at(const Number& t) const {
    const Number x = to<Number>(a.x) + t * to<Number>(step.x);
    const Number y = to<Number>(a.y) + t * to<Number>(step.y);
    return std::max(x < 0 ? Number(-x) : x, y < 0 ? Number(-y) : y);
  }
};

// The greater of |x| and |y| is least at an end, or where they are equal.
template <class Number>
[[nodiscard]] Number distance_fx8(const Edge& edge) {
  Number least = std::min(edge.distance_at(Number(0)), edge.distance_at(Number(1)));
  const auto try_zero_of = [&](int64_t at_a, int64_t step) {
    if (step == 0) return;
    const Number t = to<Number>(-at_a) / to<Number>(step);
    if (0 <= t && t <= 1) least = std::min(least, edge.distance_at(t));
  };
  try_zero_of(edge.a.x - edge.a.y, edge.step.x - edge.step.y);
  try_zero_of(edge.a.x + edge.a.y, edge.step.x + edge.step.y);
  return least;
}

// In one direction; the distance is at most `reach` where the edge is from a to a + step.
[[nodiscard]] bool overlaps(int64_t a, int64_t step, int64_t reach_fx16) {
  const int64_t least = a + std::min<int64_t>(step, 0), greatest = a + std::max<int64_t>(step, 0);
  return least * kFx16PerFx8 <= reach_fx16 && -reach_fx16 <= greatest * kFx16PerFx8;
}

// Whether the edge meets the square of that half side: it spans it in both directions, and its line
// does not leave all of it on one side. Below 2^60.
[[nodiscard]] bool is_near(const Edge& edge, int64_t reach_fx16) {
  const auto& [a, step] = edge;
  if (!overlaps(a.x, step.x, reach_fx16) || !overlaps(a.y, step.y, reach_fx16)) return false;
  const int64_t cross = std::abs(a.x * step.y - a.y * step.x);
  return cross * kFx16PerFx8 <= reach_fx16 * (std::abs(step.x) + std::abs(step.y));
}

template <class Visit>
void for_each_edge(Point p, std::span<const selvage_vertex> outline, const Visit& visit) {
  for (size_t i = 0; i < outline.size(); ++i) {
    visit(Edge(p, outline[i], outline[(i + 1) % outline.size()]));
  }
}

template <class Number>
[[nodiscard]] Number distance_px(Point p, std::span<const selvage_vertex> outline) {
  Number least = Edge(p, outline.front(), outline.front()).distance_at(Number(0));
  for_each_edge(p, outline,
                [&](const Edge& edge) { least = std::min(least, distance_fx8<Number>(edge)); });
  return least / Number(static_cast<int>(SELVAGE_SUBPIXELS));
}

}  // namespace

Rational outline_distance_px(Point p, std::span<const selvage_vertex> outline) {
  return distance_px<Rational>(p, outline);
}

double about_outline_distance_px(Point p, std::span<const selvage_vertex> outline) {
  return distance_px<double>(p, outline);
}

bool is_near_outline(Point p, std::span<const selvage_vertex> outline, int32_t reach_fx16) {
  bool is_any_near = false;
  for_each_edge(p, outline,
                [&](const Edge& edge) { is_any_near = is_any_near || is_near(edge, reach_fx16); });
  return is_any_near;
}

}  // namespace selvage::spec
