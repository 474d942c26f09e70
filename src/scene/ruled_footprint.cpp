#include "scene/ruled_footprint.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "scene/screen_face.h"

namespace selvage::scene {
namespace {

inline constexpr double kLeastWidth_px = 0x1p-12;  // below it, rounding in double could count

struct Side {  // from its upper end to its lower one
  const selvage_vertex *top = nullptr, *bottom = nullptr;
};

// Where a row meets a side.
struct End {
  double x_px, q, u_texel, v_texel;
};

// Rows between which the same two sides run: ends[0] on the upper row, ends[1] on the lower one.
struct Slab {
  std::array<End, 2> left, right;
  double height_px;
};

[[nodiscard]] End end_of(const Side& side, int32_t y) {
  const selvage_vertex &a = *side.top, &b = *side.bottom;
  if (y == a.y) return {to_px(a.x), double(a.q), a.u / kSubtexels, a.v / kSubtexels};
  if (y == b.y) return {to_px(b.x), double(b.q), b.u / kSubtexels, b.v / kSubtexels};
  const double t = double(y - a.y) / double(b.y - a.y);
  const double of_a = (1 - t) * a.q, of_b = t * b.q, q = of_a + of_b;
  return {to_px(a.x) + t * to_px(b.x - a.x), q, (of_a * a.u + of_b * b.u) / (q * kSubtexels),
          (of_a * a.v + of_b * b.v) / (q * kSubtexels)};
}

// The sides that run down, and those that run up, each from the top.
[[nodiscard]] std::array<std::vector<Side>, 2> chains(std::span<const selvage_vertex> vertices) {
  std::array<std::vector<Side>, 2> chains;
  for (size_t i = 0; i < vertices.size(); ++i) {
    const selvage_vertex& a = vertices[i];
    const selvage_vertex& b = vertices[(i + 1) % vertices.size()];
    if (a.y < b.y) chains[0].push_back({&a, &b});
    if (a.y > b.y) chains[1].push_back({&b, &a});
  }
  for (std::vector<Side>& chain : chains) {
    std::sort(chain.begin(), chain.end(),
              [](const Side& a, const Side& b) { return a.top->y < b.top->y; });
  }
  return chains;
}

// In Bernstein's form of degree 2: a quantity's values along one parameter.
using Quadratic = std::array<double, 3>;

// The numerator of u's change from a row of ends to another, over q^2: q0 U1 - q1 U0, U = u q.
[[nodiscard]] Quadratic change(const std::array<End, 2>& from, const std::array<End, 2>& to,
                               double End::*u) {
  const auto term = [u](const End& a, const End& b) { return a.q * b.q * (b.*u - a.*u); };
  return {term(from[0], to[0]), (term(from[0], to[1]) + term(from[1], to[0])) / 2,
          term(from[1], to[1])};
}

[[nodiscard]] Quadratic raised(double from, double to) { return {from, (from + to) / 2, to}; }

// Degree 3 of degree 2.
[[nodiscard]] std::array<double, 4> raised(const Quadratic& a) {
  return {a[0], (a[0] + 2 * a[1]) / 3, (2 * a[1] + a[2]) / 3, a[2]};
}

// The product with a linear function.
[[nodiscard]] std::array<double, 4> product(const Quadratic& a, double from, double to) {
  return {a[0] * from, (a[0] * to + 2 * a[1] * from) / 3, (2 * a[1] * to + a[2] * from) / 3,
          a[2] * to};
}

// q^2 along the rows' parameter for one of the three coefficients across.
[[nodiscard]] Quadratic squared_q(const Slab& slab, size_t across) {
  const End &a = slab.left[0], &b = slab.left[1], &c = slab.right[0], &d = slab.right[1];
  if (across == 0) return {a.q * a.q, a.q * b.q, b.q * b.q};
  if (across == 2) return {c.q * c.q, c.q * d.q, d.q * d.q};
  return {a.q * c.q, (a.q * d.q + b.q * c.q) / 2, b.q * d.q};
}

[[nodiscard]] double bound_of(const Slab& slab, double End::*u) {
  const double width[] = {slab.right[0].x_px - slab.left[0].x_px,
                          slab.right[1].x_px - slab.left[1].x_px};
  const Quadratic slant =
      raised(slab.left[1].x_px - slab.left[0].x_px, slab.right[1].x_px - slab.right[0].x_px);
  const Quadratic widths = raised(width[0], width[1]);
  const Quadratic along = change(slab.left, slab.right, u);
  const Quadratic down = change({slab.left[0], slab.right[0]}, {slab.left[1], slab.right[1]}, u);
  const auto along_x = raised(along);
  double greatest = 0;
  for (size_t i = 0; i < 3; ++i) {
    Quadratic numerator;
    for (size_t j = 0; j < 3; ++j) numerator[j] = down[i] * widths[j] - slant[i] * along[j];
    const auto along_y = raised(numerator);
    const auto denominator = product(squared_q(slab, i), width[0], width[1]);
    for (size_t j = 0; j < 4; ++j) {
      if ((j == 0 && width[0] == 0) || (j == 3 && width[1] == 0)) continue;  // a common factor
      greatest = std::max(greatest, (std::abs(along_x[j]) + std::abs(along_y[j]) / slab.height_px) /
                                        denominator[j]);
    }
  }
  return greatest;
}

[[nodiscard]] double bound_of(Slab slab) {
  if (slab.left[0].x_px + slab.left[1].x_px > slab.right[0].x_px + slab.right[1].x_px)
    std::swap(slab.left, slab.right);
  const double top = slab.right[0].x_px - slab.left[0].x_px;
  const double bottom = slab.right[1].x_px - slab.left[1].x_px;
  if (top == 0 && bottom == 0) return 0;  // nothing is in it
  const auto narrow = [](double px) { return px != 0 && px < kLeastWidth_px; };
  if (narrow(top) || narrow(bottom)) return std::numeric_limits<double>::infinity();
  return std::max(bound_of(slab, &End::u_texel), bound_of(slab, &End::v_texel));
}

}  // namespace

double ruled_texels_per_px_bound(std::span<const selvage_vertex> vertices) {
  const auto [down, up] = chains(vertices);
  double bound = 0;
  bool has_area = false;
  for (size_t i = 0, j = 0; i < down.size() && j < up.size();) {
    const Side &a = down[i], &b = up[j];
    const int32_t top = std::max(a.top->y, b.top->y), bottom = std::min(a.bottom->y, b.bottom->y);
    if (top < bottom) {
      has_area = true;
      bound = std::max(bound, bound_of(Slab{{end_of(a, top), end_of(a, bottom)},
                                            {end_of(b, top), end_of(b, bottom)},
                                            to_px(bottom - top)}));
    }
    i += a.bottom->y == bottom;
    j += b.bottom->y == bottom;
  }
  return has_area ? bound * kFootprintSlack : std::numeric_limits<double>::infinity();
}

}  // namespace selvage::scene
