// Mutations of the outline: vertices onto the pixel grid's own places, edges through sample points.
#include <algorithm>
#include <cstdint>

#include "spec/generate_near_ties.h"
#include "spec/geometry.h"
#include "spec/mutate_case.h"
#include "spec/profiles.h"
#include "spec/vertex_units.h"

namespace selvage::spec {
namespace {

[[nodiscard]] int32_t grid_of(const Case& c) {
  return profile_of(c).whole_px ? kPixel_fx8 : int32_t{1};
}

[[nodiscard]] selvage_vertex& any_vertex(Random& random, Case& c) {
  return c.vertices[random.below(c.vertices.size())];
}

[[nodiscard]] Point any_sample(Random& random, const Case& c) {
  const int32_t x_px = random.in(0, c.target_width_px);
  const int32_t y_px = random.in(0, c.target_height_px);
  return sample_point(profile_of(c), x_px, y_px);
}

void put(selvage_vertex& v, Point at) {
  v.x = clamped_position(at.x);
  v.y = clamped_position(at.y);
}

void nudge_vertex(Random& random, Case& c) {
  if (c.vertices.empty()) return;
  const int32_t unit = grid_of(c);
  selvage_vertex& v = any_vertex(random, c);
  const int32_t dx = random.in(-1, 2);
  const int32_t dy = random.in(-1, 2);
  put(v, {int64_t{v.x} + dx * unit, int64_t{v.y} + dy * unit});
}

void move_vertex(Random& random, Case& c) {
  if (c.vertices.empty()) return;
  const Point sample = any_sample(random, c);
  const int32_t dx = random.in(-kPixel_fx8, kPixel_fx8 + 1);
  const int32_t dy = random.in(-kPixel_fx8, kPixel_fx8 + 1);
  put(any_vertex(random, c), {sample.x + dx, sample.y + dy});
}

// To a pixel's border, its centre, or 1/256 px beside one.
void snap_vertex(Random& random, Case& c) {
  if (c.vertices.empty()) return;
  selvage_vertex& v = any_vertex(random, c);
  const auto snapped = [&](int32_t at) {
    const int32_t to = random.pick({0, kPixel_fx8 / 2, kPixel_fx8 / 2, 1, kPixel_fx8 / 2 - 1});
    return (at & ~(kPixel_fx8 - 1)) + to;
  };
  if (random.percent(70)) v.x = snapped(v.x);
  if (random.percent(70)) v.y = snapped(v.y);
}

// One end of an edge to where the edge meets a sample point, or misses it by a unit.
void edge_through_sample(Random& random, Case& c) {
  if (c.vertices.size() < 3) return;
  const size_t i = random.below(c.vertices.size());
  const size_t step = random.percent(50) ? 1 : c.vertices.size() - 1;
  const selvage_vertex& fixed = c.vertices[i];
  selvage_vertex& moved = c.vertices[(i + step) % c.vertices.size()];
  const Point sample = any_sample(random, c);
  const Point arm{sample.x - fixed.x, sample.y - fixed.y};
  const int32_t times = random.in(1, 4);
  const int32_t miss = random.pick({0, 1, -1}) * grid_of(c);
  put(moved, {sample.x + arm.x * (times - 1) + miss, sample.y + arm.y * (times - 1)});
}

// An edge that misses a sample point by as little as an edge of its length can: its ends, seen from
// there, are neighbours in a Farey sequence.
void graze_sample(Random& random, Case& c) {
  if (c.vertices.size() < 3) return;
  const int32_t side_fx8 = kPixel_fx8 * std::max(c.target_width_px, c.target_height_px);
  const auto [a, b] = random_neighbours(random, random.pick({side_fx8, 8 * side_fx8, 1 << 22}));
  const int32_t mirror = random.pick({1, -1});
  const Point sample = any_sample(random, c);
  const size_t i = random.below(c.vertices.size());
  put(c.vertices[i], {sample.x - a.x * mirror, sample.y - a.y});
  put(c.vertices[(i + 1) % c.vertices.size()], {sample.x + b.x * mirror, sample.y + b.y});
}

// A vertex onto the line between its neighbours, or a unit off it: no area, or next to none.
void flatten_vertex(Random& random, Case& c) {
  const size_t count = c.vertices.size();
  if (count < 3) return;
  const size_t i = random.below(count);
  const selvage_vertex &a = c.vertices[(i + count - 1) % count], &b = c.vertices[(i + 1) % count];
  const int64_t part = random.in(0, 17);
  const int32_t dx = random.in(-1, 2) * grid_of(c);
  const int32_t dy = random.in(-1, 2) * grid_of(c);
  put(c.vertices[i],
      {a.x + (int64_t{b.x} - a.x) * part / 16 + dx, a.y + (int64_t{b.y} - a.y) * part / 16 + dy});
}

// Slopes of small ratios without a finite binary fraction: x = y * over / under.
void set_slope(Random& random, Case& c) {
  if (c.vertices.size() < 3) return;
  const size_t i = random.below(c.vertices.size());
  const selvage_vertex& fixed = c.vertices[i];
  selvage_vertex& moved = c.vertices[(i + 1) % c.vertices.size()];
  const int64_t under = random.pick({3, 5, 7, 9, 11, 13});
  const int64_t over = random.in(-13, 14);
  const int64_t down = int64_t{moved.y} - fixed.y;
  put(moved, {fixed.x + down * over / under, moved.y});
}

void align_vertices(Random& random, Case& c) {
  if (c.vertices.size() < 2) return;
  const selvage_vertex from = any_vertex(random, c);
  selvage_vertex& to = any_vertex(random, c);
  (random.percent(50) ? to.x : to.y) = random.percent(50) ? from.x : from.y;
}

// All vertices by less than a pixel, or by whole ones.
void shift_outline(Random& random, Case& c) {
  const int32_t unit = random.percent(50) ? kPixel_fx8 : grid_of(c);
  const int32_t dx = unit * random.in(-8, 9);
  const int32_t dy = unit * random.in(-8, 9);
  for (selvage_vertex& v : c.vertices) put(v, {int64_t{v.x} + dx, int64_t{v.y} + dy});
}

// The whole outline over the target, or twice as large: longer edges and spans add up more.
void stretch_outline(Random& random, Case& c) {
  if (c.vertices.empty()) return;
  const bool wide = random.percent(50);
  const auto axis = wide ? &selvage_vertex::x : &selvage_vertex::y;
  const int64_t size_fx8 = int64_t{kPixel_fx8} * (wide ? c.target_width_px : c.target_height_px);
  const auto [low, high] = std::ranges::minmax(c.vertices, {}, axis);
  const int64_t first = low.*axis, extent = int64_t{high.*axis} - first;
  if (extent == 0) return;
  const bool doubled = random.percent(30);
  for (selvage_vertex& v : c.vertices) {
    const int64_t along = int64_t{v.*axis} - first;
    v.*axis = clamped_position(doubled ? first + 2 * along : along * size_fx8 / extent);
  }
}

void rotate_vertices(Random& random, Case& c) {
  if (c.vertices.empty()) return;
  const auto first = static_cast<std::ptrdiff_t>(random.below(c.vertices.size()));
  std::ranges::rotate(c.vertices, c.vertices.begin() + first);
}

void reverse_vertices(Random&, Case& c) { std::ranges::reverse(c.vertices); }

void drop_vertex(Random& random, Case& c) {
  if (c.vertices.size() <= 3) return;
  c.vertices.erase(c.vertices.begin() +
                   static_cast<std::ptrdiff_t>(random.below(c.vertices.size())));
}

void repeat_vertex(Random& random, Case& c) {
  if (c.vertices.empty() || c.vertices.size() >= kMaxVertices) return;
  const auto at = c.vertices.begin() + static_cast<std::ptrdiff_t>(random.below(c.vertices.size()));
  c.vertices.insert(at, selvage_vertex{*at});
}

constexpr Mutation kOutlineMutations[] = {{"nudge vertex", nudge_vertex},
                                          {"move vertex", move_vertex},
                                          {"snap vertex", snap_vertex},
                                          {"edge through sample", edge_through_sample},
                                          {"graze sample", graze_sample},
                                          {"graze sample", graze_sample},
                                          {"sliver", flatten_vertex},
                                          {"slope", set_slope},
                                          {"align vertices", align_vertices},
                                          {"shift outline", shift_outline},
                                          {"stretch outline", stretch_outline},
                                          {"rotate vertices", rotate_vertices},
                                          {"reverse vertices", reverse_vertices},
                                          {"drop vertex", drop_vertex},
                                          {"repeat vertex", repeat_vertex}};

}  // namespace

std::span<const Mutation> outline_mutations() { return kOutlineMutations; }

}  // namespace selvage::spec
