// Mutations of u, v and q: samples onto the borders of texels, steps without a finite fraction.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>

#include "spec/exact.h"
#include "spec/generate_near_ties.h"
#include "spec/model.h"
#include "spec/mutate_case.h"
#include "spec/profiles.h"
#include "spec/vertex_units.h"

namespace selvage::spec {
namespace {

[[nodiscard]] VertexField any_axis(Random& random) {
  return random.percent(50) ? &selvage_vertex::u : &selvage_vertex::v;
}

// Only if all of them fit: then what the samples tell moves by as much.
void shift_all(Case& c, VertexField axis, int64_t by_fx16) {
  const auto shifted = [&](const selvage_vertex& v) { return v.*axis + by_fx16; };
  const bool fits = std::ranges::all_of(c.vertices, [&](const selvage_vertex& v) {
    return shifted(v) == clamped_coordinate(shifted(v));
  });
  if (!fits) return;
  for (selvage_vertex& v : c.vertices) v.*axis = static_cast<int32_t>(shifted(v));
}

[[nodiscard]] std::optional<Rational> value_fx16(const Case& c, Pixel at, VertexField axis) {
  const std::optional<Sample> point = ModelRow(c, at.y_px).coordinates(at.x_px);
  if (!point) return std::nullopt;
  return Rational((axis == &selvage_vertex::u ? point->u : point->v) * kTexel_fx16 +
                  profile_of(c).rounding_fx16);
}

// A pixel of the target that is covered, if a few tries find one.
[[nodiscard]] std::optional<Pixel> covered_pixel(Random& random, const Case& c) {
  if (!is_valid(c)) return std::nullopt;
  for (int tries = 0; tries < 6; ++tries) {
    const int32_t y_px = random.in(0, c.target_height_px);
    const int32_t from_px = random.in(0, c.target_width_px);
    const ModelRow row(c, y_px);
    for (int32_t i = 0; i < std::min(c.target_width_px, 64); ++i) {
      const int32_t x_px = (from_px + i) % c.target_width_px;
      if (row.coordinates(x_px)) return Pixel{x_px, y_px};
    }
  }
  return std::nullopt;
}

// How far above the nearest step of the texel, in 1/65536.
[[nodiscard]] double miss_of(const Rational& value_fx16) {
  const Rational texels = value_fx16 / kTexel_fx16;
  const int32_t whole = floor(texels + Rational(1, 2));
  return Rational((texels - whole) * kTexel_fx16).get_d();
}

// Moves the texture so that a sample lies on a texel's border, or within a few units of it.
void tie_at_pixel(Random& random, Case& c) {
  const std::optional<Pixel> at = covered_pixel(random, c);
  if (!at) return;
  for (const VertexField axis : {&selvage_vertex::u, &selvage_vertex::v}) {
    const std::optional<Rational> value = value_fx16(c, *at, axis);
    if (!value) continue;
    const int32_t miss = random.pick({0, 0, 0, -1, -1, 1, -2, 2, -5, 5});
    shift_all(c, axis, miss - std::llround(std::floor(miss_of(*value))));
  }
}

// Two vertices' coordinates by so many units that a sample comes as near to the border as it can:
// the better of all pairs within reach, on the side that is asked for.
void refine_tie(Random& random, Case& c) {
  constexpr int32_t kReach = 24;
  const std::optional<Pixel> at = covered_pixel(random, c);
  if (!at) return;
  const VertexField axis = any_axis(random);
  const size_t i = random.below(c.vertices.size());
  const size_t j = (i + 1) % c.vertices.size();
  const bool below = random.percent(60);
  const Rational base = *value_fx16(c, *at, axis);
  const auto effect = [&](size_t vertex) {
    Case moved = c;
    moved.vertices[vertex].*axis -= moved.vertices[vertex].*axis > 0 ? 1 : -1;
    const double change = Rational(*value_fx16(moved, *at, axis) - base).get_d();
    return c.vertices[vertex].*axis > 0 ? -change : change;
  };
  const double miss = miss_of(base), by_i = effect(i), by_j = effect(j);
  const auto badness = [&](double distance) {
    return below == (distance < 0) || distance == 0 ? std::abs(distance) : 4 * std::abs(distance);
  };
  double least = badness(miss);
  std::pair<int32_t, int32_t> best{0, 0};
  for (int32_t a = -kReach; a <= kReach; ++a) {
    for (int32_t b = -kReach; b <= kReach; ++b) {
      const double distance = badness(miss + a * by_i + b * by_j);
      if (distance < least) least = distance, best = {a, b};
    }
  }
  c.vertices[i].*axis = clamped_coordinate(int64_t{c.vertices[i].*axis} + best.first);
  c.vertices[j].*axis = clamped_coordinate(int64_t{c.vertices[j].*axis} + best.second);
}

// Of a triangle: by number theory, as near as the weights of its corners allow.
void graze_texel(Random& random, Case& c) {
  if (c.vertices.size() != 3 || c.profile != SELVAGE_PROFILE_EXACT) return;
  graze_a_texel(random, Frame{c.target_width_px, c.target_height_px}, c.vertices);
}

// One plane over the outline, its steps ratios without a finite binary fraction; along rows alone,
// down columns alone, or both.
void set_plane(Random& random, Case& c) {
  const VertexField axis = any_axis(random);
  const int64_t scale = kTexel_fx16 / SELVAGE_SUBPIXELS;
  const int64_t under = random.pick({3, 5, 7, 11, 13, 27, 97});
  const int64_t reach = random.percent(70) ? 2 * under : 40 * under;
  const int64_t along = random.percent(25) ? 0 : random.in(-reach, reach + 1);
  const int64_t down = random.percent(40) ? 0 : random.in(-reach, reach + 1);
  const int64_t offset = int64_t{kTexel_fx16} * random.in(0, 8) + random.pick({0, 0, 1, -1, 32768});
  for (selvage_vertex& v : c.vertices) {
    v.*axis =
        clamped_coordinate((int64_t{v.x} * along + int64_t{v.y} * down) * scale / under + offset);
  }
}

void nudge_coordinate(Random& random, Case& c) {
  if (c.vertices.empty()) return;
  selvage_vertex& v = c.vertices[random.below(c.vertices.size())];
  const VertexField axis = any_axis(random);
  v.*axis = clamped_coordinate(int64_t{v.*axis} + random.pick({-1, 1, -2, 2, 256, -256}));
}

void move_coordinate(Random& random, Case& c) {
  if (c.vertices.empty()) return;
  selvage_vertex& v = c.vertices[random.below(c.vertices.size())];
  const bool of_u = random.percent(50);
  const int32_t size = of_u ? c.texture_width_texel : c.texture_height_texel;
  const int64_t texel = random.in(-1, int64_t{size} + 2);
  const int32_t fraction = random.pick({0, 0, 1, -1, 32768, random.in(0, kTexel_fx16)});
  v.*(of_u ? &selvage_vertex::u : &selvage_vertex::v) =
      clamped_coordinate(texel * kTexel_fx16 + fraction);
}

void scale_coordinates(Random& random, Case& c) {
  const VertexField axis = any_axis(random);
  const int64_t times = random.pick({2, 2, 3, 8, -1, 1, 1});
  const int64_t over = random.pick({1, 1, 2, 3, 16});
  for (selvage_vertex& v : c.vertices) v.*axis = clamped_coordinate(v.*axis * times / over);
}

void shift_texels(Random& random, Case& c) {
  const int64_t texels = random.in(-20, 21);
  shift_all(c, any_axis(random), texels * kTexel_fx16);
}

void exchange_coordinates(Random&, Case& c) {
  for (selvage_vertex& v : c.vertices) std::swap(v.u, v.v);
}

// q: all but equal, equal, in a ratio, the other way round.
void nearly_equal_q(Random& random, Case& c) {
  if (c.vertices.empty()) return;
  const int32_t q = random.pick({1, 255, 65536, kQMax - 1, c.vertices.front().q});
  for (selvage_vertex& v : c.vertices) v.q = std::min(q, kQMax - 1);
  ++c.vertices[random.below(c.vertices.size())].q;
}

void equal_q(Random& random, Case& c) {
  if (c.vertices.empty()) return;
  const int32_t q = random.pick({1, c.vertices.front().q, kQMax});
  for (selvage_vertex& v : c.vertices) v.q = q;
}

void scale_one_q(Random& random, Case& c) {
  if (c.vertices.empty()) return;
  selvage_vertex& v = c.vertices[random.below(c.vertices.size())];
  const int64_t q = random.percent(50) ? int64_t{v.q} * random.in(2, 9) : v.q / random.in(2, 9);
  v.q = static_cast<int32_t>(std::clamp<int64_t>(q, 1, kQMax));
}

void nudge_q(Random& random, Case& c) {
  if (c.vertices.empty()) return;
  selvage_vertex& v = c.vertices[random.below(c.vertices.size())];
  v.q = std::clamp(v.q + random.pick({-1, 1}), 1, kQMax);
}

constexpr Mutation kTexelMutations[] = {{"tie at pixel", tie_at_pixel},
                                        {"tie at pixel", tie_at_pixel},
                                        {"refine tie", refine_tie},
                                        {"refine tie", refine_tie},
                                        {"graze texel", graze_texel},
                                        {"graze texel", graze_texel},
                                        {"graze texel", graze_texel},
                                        {"plane", set_plane},
                                        {"plane", set_plane},
                                        {"nudge coordinate", nudge_coordinate},
                                        {"move coordinate", move_coordinate},
                                        {"scale coordinates", scale_coordinates},
                                        {"shift texels", shift_texels},
                                        {"exchange coordinates", exchange_coordinates},
                                        {"nearly equal q", nearly_equal_q},
                                        {"equal q", equal_q},
                                        {"scale one q", scale_one_q},
                                        {"nudge q", nudge_q}};

}  // namespace

std::span<const Mutation> texel_mutations() { return kTexelMutations; }

}  // namespace selvage::spec
