// Outlines made of whole chains of edges.
#include <algorithm>

#include "spec/shape_families.h"
#include "spec/vertex_units.h"

namespace selvage::spec {
namespace {

// The differences along two random ways from the least number to the greatest: one way forward, the
// other one back, so that they add up to 0.
[[nodiscard]] std::vector<int32_t> closed_steps(Random& random, std::vector<int32_t> numbers) {
  std::sort(numbers.begin(), numbers.end());
  std::vector<int32_t> steps;
  int32_t there = numbers.front(), back = numbers.front();
  for (size_t i = 1; i + 1 < numbers.size(); ++i) {
    if (random.percent(50)) {
      steps.push_back(numbers[i] - there);
      there = numbers[i];
    } else {
      steps.push_back(back - numbers[i]);
      back = numbers[i];
    }
  }
  steps.push_back(numbers.back() - there);
  steps.push_back(back - numbers.back());
  return steps;
}

void shuffle(Random& random, std::vector<int32_t>& values) {
  for (size_t i = values.size(); i > 1; --i) std::swap(values[i - 1], values[random.below(i)]);
}

[[nodiscard]] bool in_upper_half(const Point& p) { return p.y > 0 || (p.y == 0 && p.x > 0); }

// By direction around the circle, then by length, so that every library sorts alike; no vector is
// (0, 0).
[[nodiscard]] bool turns_before(const Point& a, const Point& b) {
  if (in_upper_half(a) != in_upper_half(b)) return in_upper_half(a);
  const int64_t cross = a.x * b.y - a.y * b.x;
  return cross != 0 ? cross > 0 : a.x * a.x + a.y * a.y < b.x * b.x + b.y * b.y;
}

[[nodiscard]] bool higher(const Point& a, const Point& b) {
  return a.y != b.y ? a.y < b.y : a.x < b.x;
}
[[nodiscard]] bool lower(const Point& a, const Point& b) { return higher(b, a); }

[[nodiscard]] std::vector<int32_t> grid_positions(Random& random, size_t count, int32_t size_px,
                                                  int32_t step_fx8) {
  std::vector<int32_t> positions;
  for (size_t i = 0; i < count; ++i) {
    positions.push_back(grid_position_fx8(random, size_px, step_fx8));
  }
  return positions;
}

}  // namespace

// Edge vectors that add up to zero, in the order of their directions (after Valtr, "Probability
// that n random points are in convex position", 1995). Collinear runs arise where directions are
// equal.
Outline convex(Random& random, const Frame& frame) {
  const size_t count = random.percent(85)   ? 3 + random.below(10)
                       : random.percent(90) ? 13 + random.below(52)
                                            : 65 + random.below(136);
  const int32_t step_fx8 = random.pick({1, 1, 16, kHalfPixel_fx8, kPixel_fx8});
  std::vector<int32_t> xs = grid_positions(random, count, frame.width_px, step_fx8);
  std::vector<int32_t> ys = grid_positions(random, count, frame.height_px, step_fx8);
  const int32_t left_fx8 = *std::min_element(xs.begin(), xs.end());
  const int32_t top_fx8 = *std::min_element(ys.begin(), ys.end());
  xs = closed_steps(random, xs);
  ys = closed_steps(random, ys);
  shuffle(random, ys);
  Outline steps;
  for (size_t i = 0; i < count; ++i) {
    if (xs[i] != 0 || ys[i] != 0) steps.push_back({xs[i], ys[i]});
  }
  std::sort(steps.begin(), steps.end(), turns_before);
  Outline outline;
  Point at{0, 0}, least{0, 0};
  for (const Point& step : steps) {
    outline.push_back(at);
    at = {at.x + step.x, at.y + step.y};
    least = {std::min(least.x, at.x), std::min(least.y, at.y)};
  }
  if (outline.size() < 3) outline.resize(3);
  for (Point& point : outline) {
    point = {point.x - least.x + left_fx8, point.y - least.y + top_fx8};
  }
  return outline;
}

Outline chains(Random& random, const Frame& frame) {
  const size_t down = random.below(random.percent(90) ? 6 : 40);
  const size_t up = 1 + random.below(random.percent(90) ? 5 : 40);
  const bool on_grid = random.percent(50);
  const auto coordinate_fx8 = [&](int32_t size_px) {
    return on_grid ? grid_position_fx8(random, size_px, kHalfPixel_fx8)
                   : position_fx8(random, size_px);
  };
  Outline outline;
  for (size_t i = 0; i < 2 + down + up; ++i) {
    outline.push_back({coordinate_fx8(frame.width_px), coordinate_fx8(frame.height_px)});
  }
  const auto first = outline.begin();
  const auto bottom = first + static_cast<std::ptrdiff_t>(down) + 1;
  std::iter_swap(first, std::min_element(first, outline.end(), higher));
  std::iter_swap(bottom, std::max_element(first + 1, outline.end(), higher));
  std::sort(first + 1, bottom, higher);
  std::sort(bottom + 1, outline.end(), lower);
  return outline;
}

}  // namespace selvage::spec
