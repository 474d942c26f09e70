// Hard for coverage: slivers, needles, edges through samples and edges that just miss them.
#include <algorithm>
#include <cstdlib>

#include "spec/generate_near_ties.h"
#include "spec/hard_makers.h"
#include "spec/hard_tools.h"
#include "spec/vertex_units.h"

namespace selvage::spec {
namespace {

// Two vectors with cross product 1, the first with both components odd: counted in pixels from a
// whole pixel, its middle is a pixel centre. Two of them fit into any screen.
constexpr Neighbours kOddSteps[] = {{{1, 1}, {0, 1}}, {{3, 1}, {2, 1}}, {{5, 1}, {4, 1}},
                                    {{7, 3}, {2, 1}}, {{1, 3}, {0, 1}}, {{5, 3}, {3, 2}},
                                    {{7, 5}, {4, 3}}, {{1, 7}, {0, 1}}};

// An edge of so many steps, a pixel centre on it, and the third corner beside it.
struct Sliver {
  Point from, step;
  int64_t count;
  Point centre, third;
};

// How many steps fit, and a place for the first that leaves them room.
struct Room {
  int64_t count, x_px, y_px;
};

[[nodiscard]] Room room_for(Random& random, Point step_px, Frame frame) {
  const int64_t count = std::min(frame.width_px / std::abs(step_px.x), frame.height_px / step_px.y);
  const int32_t x_px = random.in(0, frame.width_px - count * std::abs(step_px.x) + 1);
  const int32_t y_px = random.in(0, frame.height_px - count * step_px.y + 1);
  return {count, step_px.x < 0 ? frame.width_px - x_px : x_px, y_px};
}

[[nodiscard]] Point mirrored(Point p, int32_t sign) { return {p.x * sign, p.y}; }

// On whole pixels; as many half square pixels as steps.
[[nodiscard]] Sliver whole_sliver(Random& random, Frame frame) {
  const auto [along_px, beside_px] = random.pick(kOddSteps);
  const int32_t sign = random.pick({1, -1});
  const Room room = room_for(random, mirrored(along_px, sign), frame);
  const Point from = kPixel_fx8 * Point{room.x_px, room.y_px};
  const Point step = kPixel_fx8 * mirrored(along_px, sign);
  const int64_t part = random.in(0, room.count);
  return {from, step, room.count, from + kHalfPixel_fx8 * mirrored(along_px, sign),
          from + part * step + kPixel_fx8 * mirrored(beside_px, sign)};
}

// Of 1/65536 square pixel: a centre in the middle of an edge of two primitive steps.
[[nodiscard]] Sliver least_sliver(Random& random, Frame frame) {
  const int32_t reach_fx8 = std::min(frame.width_px, frame.height_px) * kHalfPixel_fx8;
  const auto [along, beside] = random_neighbours(random, reach_fx8);
  const int32_t sign = random.pick({1, -1});
  const int32_t x_px = random.in(frame.width_px / 4, frame.width_px * 3 / 4);
  const int32_t y_px = random.in(frame.height_px / 4, frame.height_px * 3 / 4);
  const Point centre = pixel_centre(x_px, y_px), step = mirrored(along, sign);
  return {centre - step, step, 2, centre, centre - step + mirrored(beside, sign)};
}

// From centre to centre through centres, the third corner 1/256 px or little more beside.
[[nodiscard]] Sliver centre_sliver(Random& random, Frame frame) {
  const auto [along_px, beside_px] = random.pick(kOddSteps);
  const Point step_px = mirrored(along_px, random.pick({1, -1}));
  const Room room = room_for(random, step_px, frame);
  const Point from =
      kPixel_fx8 * Point{room.x_px, room.y_px} + Point{-kHalfPixel_fx8, -kHalfPixel_fx8};
  const Point step = kPixel_fx8 * step_px;
  const Point way = room.count * step;
  const int32_t percent = random.in(0, 101);
  const Point off{random.pick({1, 1, 2, 16, 64}), 0};
  return {from, step, room.count, from + step,
          from + Point{way.x * percent / 100, way.y * percent / 100} + off};
}

}  // namespace

Case make_sliver(uint64_t seed) {
  Draft draft(seed);
  const Frame frame = screen(draft);
  Case c = start(draft, frame, screen_texture(draft));
  const Sliver sliver = draft.whole_px             ? whole_sliver(draft.random, frame)
                        : draft.random.percent(50) ? least_sliver(draft.random, frame)
                                                   : centre_sliver(draft.random, frame);
  const Point to = sliver.from + sliver.count * sliver.step;
  set_outline(&c, {sliver.from, to, sliver.third});
  // The centre is on a left edge of the sliver or else of its reflection.
  if (winding_number(sliver.centre, c.vertices) == 0) {
    set_outline(&c, {sliver.from, to, sliver.from + to - sliver.third});
  }
  if (draft.random.percent(50)) {
    map_across(draft, &c);
  } else {
    map_anywhere(draft, &c);
  }
  return c;
}

namespace {

// A row of the target that a needle lies in.
struct Lane {
  int32_t width_px, row_px;
  [[nodiscard]] int64_t left() const { return 0; }
  [[nodiscard]] int64_t right() const { return int64_t{width_px} * kPixel_fx8; }
  [[nodiscard]] int64_t top() const { return int64_t{row_px} * kPixel_fx8; }
  [[nodiscard]] int64_t centre() const { return top() + kHalfPixel_fx8; }
};

[[nodiscard]] Outline whole_needle(Random& random, const Lane& lane) {
  const int64_t bottom = lane.top() + kPixel_fx8;
  const int64_t slant = int64_t{random.in(0, lane.width_px / 8)} * kPixel_fx8;
  const int64_t tip = int64_t{random.in(0, lane.width_px + 1)} * kPixel_fx8;
  switch (random.in(0, 3)) {
    case 0:
      return {{lane.left(), lane.top()}, {lane.right(), lane.top()}, {tip, bottom}};
    case 1:
      return {{lane.left(), bottom}, {lane.right(), bottom}, {tip, lane.top()}};
    default:
      return parallelogram({lane.left(), lane.top()}, {lane.right() - slant, 0},
                           {slant, kPixel_fx8});
  }
}

// From 1/128 to 1 px high, about the centres of the row, or with a flat top on them.
[[nodiscard]] Outline fine_needle(Random& random, const Lane& lane) {
  const int64_t left = lane.left() + random.pick({0, -kPixel_fx8, kHalfPixel_fx8, 1, -1});
  const int64_t right = lane.right() + random.pick({0, kPixel_fx8, 1 - kHalfPixel_fx8, -1, 1});
  const int64_t low_left = random.pick({1, 2, 64, 128}), low_right = random.pick({1, 2, 64, 128});
  const int64_t high_left = random.pick({1, 64, 127}), high_right = random.pick({1, 64, 127});
  const int64_t tip = random.in(left, right + 1);
  const int64_t y = lane.centre();
  if (random.percent(40)) return {{left, y}, {right, y}, {tip, y + low_left}};
  return {
      {left, y - high_left}, {right, y - high_right}, {right, y + low_right}, {left, y + low_left}};
}

}  // namespace

Case make_needle_row(uint64_t seed) {
  Draft draft(seed);
  const Frame frame = draft.small
                          ? draft.random.pick({Frame{512, 1}, Frame{256, 2}, Frame{200, 3}})
                          : draft.random.pick({Frame{8192, 4}, Frame{16384, 2}, Frame{4096, 8}});
  Case c = start(draft, frame, draft.small ? TextureSize{512, 4} : TextureSize{4096, 16});
  const Lane lane{frame.width_px, draft.random.in(0, frame.height_px)};
  set_outline(&c,
              draft.whole_px ? whole_needle(draft.random, lane) : fine_needle(draft.random, lane));
  map_axes(draft, &c);
  return c;
}

Case make_needle_column(uint64_t seed) {
  Case c = make_needle_row(seed);
  swap_axes(&c);
  return c;
}

namespace {

// The first to the right and down or level, the second down to the left.
struct Directions {
  Point right, left;
};

// A parallelogram, or a triangle, with sides of whole numbers of steps along the directions, of
// `unit_fx8` in x and y each. All vertices are whole numbers of steps from first_fx8.
[[nodiscard]] Outline of_steps(Random& random, Frame frame, Directions go, int32_t unit_fx8,
                               int32_t first_fx8) {
  const int64_t width = (frame.width_px * kPixel_fx8 - first_fx8) / unit_fx8;
  const int64_t height = (frame.height_px * kPixel_fx8 - first_fx8) / unit_fx8;
  const auto count_of = [&](Point step) {
    const int64_t most_across = width / 2 / std::abs(step.x);
    const int64_t most = step.y == 0 ? most_across : std::min(most_across, height / 2 / step.y);
    return int64_t{random.in((most + 1) / 2, most + 1)};
  };
  const Point a = count_of(go.right) * go.right;
  const Point b = count_of(go.left) * go.left;
  const int32_t x = random.in(-b.x, width - a.x + 1);
  const int32_t y = random.in(0, height - a.y - b.y + 1);
  Outline outline = parallelogram({x, y}, a, b);
  if (random.percent(35)) outline.erase(outline.begin() + 2);
  for (Point& p : outline) p = unit_fx8 * p + Point{first_fx8, first_fx8};
  return outline;
}

}  // namespace

// On whole pixels, steps of two odd numbers have a centre in their middle; on centres, any step
// ends on one.
Case make_edges_through_samples(uint64_t seed) {
  Draft draft(seed);
  const Frame frame = screen(draft);
  Case c = start(draft, frame, screen_texture(draft));
  const Point odd_right =
      draft.random.pick<Point>({{5, 3}, {3, 5}, {7, 3}, {5, 1}, {1, 5}, {7, 5}});
  const Point odd_left = draft.random.pick<Point>({{-1, 1}, {-1, 3}, {-3, 1}});
  const Point any_right =
      draft.random.pick<Point>({{2, 1}, {3, 2}, {5, 2}, {1, 2}, {2, 5}, {1, 0}});
  const Point any_left = draft.random.pick<Point>({{-1, 2}, {-2, 3}, {-3, 5}, {-2, 1}, {-3, 2}});
  const Directions directions =
      draft.whole_px ? Directions{odd_right, odd_left} : Directions{any_right, any_left};
  set_outline(&c, of_steps(draft.random, frame, directions, kPixel_fx8,
                           draft.whole_px ? 0 : kHalfPixel_fx8));
  map_across(draft, &c);
  return c;
}

Case make_slopes_45(uint64_t seed) {
  Draft draft(seed);
  const Frame frame = screen(draft);
  Case c = start(draft, frame, screen_texture(draft));
  set_outline(&c, of_steps(draft.random, frame, {{1, 1}, {-1, 1}}, kPixel_fx8,
                           draft.whole_px ? 0 : kHalfPixel_fx8));
  const int32_t sign = draft.random.pick({1, -1});
  const int32_t under = draft.random.pick({1, 1, 2});
  map_on_boundaries(&c, {1, sign, under}, {-1, sign, under});
  return c;
}

Case make_slopes_thirds(uint64_t seed) {
  Draft draft(seed);
  const Frame frame = screen(draft);
  Case c = start(draft, frame, screen_texture(draft));
  const Point right = draft.random.pick<Point>({{3, 1}, {1, 3}});
  const Point left = draft.random.pick<Point>({{-3, 1}, {-1, 3}});
  // Whole pixels that are thirds of a step away from centres: 2.0 - 0.5 = 3 / 2.
  set_outline(&c, of_steps(draft.random, frame, {right, left}, 3 * kPixel_fx8,
                           draft.whole_px ? 2 * kPixel_fx8 : kHalfPixel_fx8));
  const int32_t sign = draft.random.pick({1, -1});
  const Slope u = draft.random.pick<Slope>({{1, 0, 3}, {2, sign, 3}, {1, sign, 3}});
  map_on_boundaries(&c, u, {-u.along_y, u.along_x, 3});
  return c;
}

namespace {

[[nodiscard]] bool is_inside_texture(const Case& c) {
  return std::ranges::all_of(c.vertices, [&](const selvage_vertex& v) {
    return 0 <= v.u && v.u >> 16 < c.texture_width_texel && 0 <= v.v &&
           v.v >> 16 < c.texture_height_texel;
  });
}

}  // namespace

// Edges always graze a centre; half of the maps graze a texel's border. Trying ends: about one
// outline in two covers something, one map in ten stays inside the texture.
Case make_near_ties(uint64_t seed) {
  Draft draft(seed);
  const Frame frame = screen(draft);
  Case c = start(draft, frame, screen_texture(draft));
  const bool graze_texels = draft.random.percent(50);
  for (;;) {
    set_outline(&c, grazing(draft.random, frame));
    if (!covers_a_pixel(c)) continue;
    if (!graze_texels) break;
    map_anywhere(draft, &c);
    const std::vector<selvage_vertex> before = c.vertices;
    graze_a_texel(draft.random, frame, c.vertices);
    if (is_inside_texture(c) && before[0].u != c.vertices[0].u) return c;
  }
  map_about_the_middle(draft, &c);
  return c;
}

}  // namespace selvage::spec
