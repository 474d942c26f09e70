#include "spec/gradient.h"

#include <utility>
#include <vector>

namespace selvage::spec {
namespace {

// A value with its derivative. The map is computed on these as it is on numbers; the rules of sum,
// product and quotient do the rest.
struct Dual {
  Rational value, change{};

  friend Dual operator+(const Dual& a, const Dual& b) {
    return {a.value + b.value, a.change + b.change};
  }
  friend Dual operator-(const Dual& a, const Dual& b) {
    return {a.value - b.value, a.change - b.change};
  }
  friend Dual operator*(const Dual& a, const Dual& b) {
    return {a.value * b.value, a.change * b.value + a.value * b.change};
  }
  friend Dual operator/(const Dual& a, const Dual& b) {
    return {a.value / b.value, (a.change * b.value - a.value * b.change) / (b.value * b.value)};
  }
};

[[nodiscard]] Dual mix(const Dual& a, const Dual& b, const Dual& t) { return a + t * (b - a); }

struct DualCrossing {
  Dual x, uq, vq, q;
};

[[nodiscard]] DualCrossing mix(const DualCrossing& a, const DualCrossing& b, const Dual& t) {
  return {mix(a.x, b.x, t), mix(a.uq, b.uq, t), mix(a.vq, b.vq, t), mix(a.q, b.q, t)};
}

[[nodiscard]] DualCrossing dual_at_vertex(const selvage_vertex& p) {
  const Rational q(p.q);
  return {{to_px(p.x)},
          {Rational(p.u) / SELVAGE_SUBTEXELS * q},
          {Rational(p.v) / SELVAGE_SUBTEXELS * q},
          {q}};
}

// Where the line at height y meets the edges that it crosses at y's value, left one first.
[[nodiscard]] std::vector<DualCrossing> crossings(std::span<const selvage_vertex> vertices,
                                                  const Dual& y) {
  std::vector<DualCrossing> found;
  for (size_t i = 0; i < vertices.size(); ++i) {
    const selvage_vertex& a = vertices[i];
    const selvage_vertex& b = vertices[(i + 1) % vertices.size()];
    const auto [top, bottom] = a.y <= b.y ? std::pair(a, b) : std::pair(b, a);
    if (!(to_px(top.y) <= y.value && y.value < to_px(bottom.y))) continue;
    const Dual t = (y - Dual{to_px(top.y)}) / Dual{to_px(bottom.y) - to_px(top.y)};
    found.push_back(mix(dual_at_vertex(top), dual_at_vertex(bottom), t));
  }
  if (found.size() == 2 && found[1].x.value < found[0].x.value) std::swap(found[0], found[1]);
  return found;
}

struct DualSample {
  Dual u, v;
};

// Section 4, at (x, y) that change as given.
[[nodiscard]] std::optional<DualSample> map(std::span<const selvage_vertex> vertices, const Dual& x,
                                            const Dual& y) {
  const std::vector<DualCrossing> ends = crossings(vertices, y);
  if (ends.size() != 2) return std::nullopt;
  const DualCrossing &left = ends[0], &right = ends[1];
  if (x.value < left.x.value || right.x.value <= x.value) return std::nullopt;
  const DualCrossing point = mix(left, right, (x - left.x) / (right.x - left.x));
  return DualSample{point.uq / point.q, point.vq / point.q};
}

}  // namespace

std::optional<Gradient> gradient(std::span<const selvage_vertex> vertices, int32_t x_px,
                                 int32_t y_px) {
  const Rational x = x_px + Rational(1, 2), y = y_px + Rational(1, 2);
  const std::optional<DualSample> along_x = map(vertices, {x, 1}, {y});
  const std::optional<DualSample> along_y = map(vertices, {x}, {y, 1});
  if (!along_x || !along_y) return std::nullopt;
  return Gradient{along_x->u.change, along_y->u.change, along_x->v.change, along_y->v.change};
}

}  // namespace selvage::spec
