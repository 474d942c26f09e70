#include "spec/generate_near_ties.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <numeric>
#include <utility>

#include "spec/geometry.h"
#include "spec/shape_families.h"
#include "spec/vertex_units.h"

namespace selvage::spec {

Neighbours random_neighbours(Random& random, int32_t reach_fx8) {
  Neighbours pair{{1, 0}, {0, 1}};
  const int lean = random.in(10, 91);
  for (;;) {
    const Point sum{pair.a.x + pair.b.x, pair.a.y + pair.b.y};
    if (sum.x + sum.y > reach_fx8) return pair;
    (random.percent(lean) ? pair.a : pair.b) = sum;
  }
}

Outline grazing(Random& random, const Frame& frame) {
  const int32_t side_fx8 = kPixel_fx8 * std::max(frame.width_px, frame.height_px);
  const int32_t reach_fx8 = random.pick({side_fx8, side_fx8, 8 * side_fx8, 1 << 22});
  const auto [a, b] = random_neighbours(random, reach_fx8);
  const int32_t mirror = random.pick({1, -1});
  const int32_t column_px = random.in(0, frame.width_px);
  const int32_t row_px = random.in(0, frame.height_px);
  const Point centre = pixel_centre(column_px, row_px);
  const Point above{centre.x - a.x * mirror, centre.y - a.y};
  const Point below{centre.x + b.x * mirror, centre.y + b.y};
  const int32_t x_fx8 = position_fx8(random, frame.width_px);
  const int32_t y_fx8 = position_fx8(random, frame.height_px);
  return {above, below, {x_fx8, y_fx8}};
}

namespace {

// x with a x = 1 (mod m), for coprime a and m > 0, by the extended Euclidean algorithm.
[[nodiscard]] int64_t inverse(int64_t a, int64_t m) {
  int64_t r = m, next_r = ((a % m) + m) % m, x = 0, next_x = 1;
  while (next_r != 0) {
    const int64_t quotient = r / next_r;
    r = std::exchange(next_r, r - quotient * next_r);
    x = std::exchange(next_x, x - quotient * next_x);
  }
  return ((x % m) + m) % m;
}

// How much each vertex weighs in the coordinates at a point: its barycentric weight times q. All 0
// where that would not fit.
[[nodiscard]] std::array<int64_t, 3> weights_at(Point p, std::span<const selvage_vertex> v) {
  constexpr int64_t kMostArea = int64_t{1} << 38;
  const Point a = position(v[0]), b = position(v[1]), c = position(v[2]);
  const int64_t sign = doubled_area(a, b, c) < 0 ? -1 : 1;
  std::array<int64_t, 3> weights = {sign * doubled_area(p, b, c), sign * doubled_area(a, p, c),
                                    sign * doubled_area(a, b, p)};
  for (size_t k = 0; k < 3; ++k) {
    if (std::abs(weights[k]) > kMostArea) return {};
    weights[k] *= v[k].q;
  }
  return weights;
}

[[nodiscard]] bool all_positive(const std::array<int64_t, 3>& w) { return std::ranges::min(w) > 0; }

// Solves w[0] f[0] + w[1] f[1] + w[2] f[2] = 65536 texel (w[0] + w[1] + w[2]) + miss for the 16.16
// coordinates f, the weights reduced by their common divisor; false where f does not fit.
[[nodiscard]] bool solve(Random& random, std::array<int64_t, 3> w, int64_t miss,
                         std::array<int32_t, 3>* f) {
  constexpr int64_t kMostWeight = int64_t{1} << 28, kMostTries = 4096;
  const int64_t common = std::gcd(std::gcd(w[0], w[1]), w[2]);
  for (int64_t& weight : w) weight /= common;
  const int64_t shared = std::gcd(w[0], w[1]);  // coprime to w[2], so some f[2] makes up for it
  if (std::ranges::max(w) > kMostWeight || shared > kMostTries) return false;
  const int64_t texel = random.in(-3, 40);
  int64_t third = random.in(-4 * SELVAGE_SUBTEXELS, 40 * SELVAGE_SUBTEXELS);
  const int64_t sum = SELVAGE_SUBTEXELS * texel * (w[0] + w[1] + w[2]) + miss;
  while ((sum - w[2] * third) % shared != 0) ++third;
  const int64_t a = w[0] / shared, b = w[1] / shared, rest = (sum - w[2] * third) / shared;
  const int64_t first = ((rest % b) + b) % b * inverse(a, b) % b;
  const int64_t second = (rest - a * first) / b;
  if (second != static_cast<int32_t>(second)) return false;
  *f = {static_cast<int32_t>(first), static_cast<int32_t>(second), static_cast<int32_t>(third)};
  return true;
}

}  // namespace

void graze_a_texel(Random& random, const Frame& frame, std::span<selvage_vertex> triangle) {
  std::array<int64_t, 3> weights{};
  for (int tries = 0; tries < 16 && !all_positive(weights); ++tries) {
    const int32_t column_px = random.in(0, frame.width_px);
    const int32_t row_px = random.in(0, frame.height_px);
    weights = weights_at(pixel_centre(column_px, row_px), triangle);
  }
  if (!all_positive(weights)) return;
  for (const auto axis : {&selvage_vertex::u, &selvage_vertex::v}) {
    const int64_t miss = random.pick({-1, -1, 0, 1});
    std::array<int32_t, 3> coordinates{};
    if (!solve(random, weights, miss, &coordinates)) continue;
    for (size_t k = 0; k < 3; ++k) triangle[k].*axis = coordinates[k];
  }
}

}  // namespace selvage::spec
