// Hard by their outlines: repeated vertices, collinear runs, flat tops and bottoms, many corners.
#include <algorithm>

#include "spec/hard_makers.h"
#include "spec/hard_tools.h"
#include "spec/vertex_units.h"

namespace selvage::spec {

// On whole pixels a repeated vertex is the same in all; else it may have texels of its own.
Case make_repeated_vertices(uint64_t seed) {
  Draft draft(seed);
  const Frame frame = screen(draft);
  Case c = start(draft, frame, screen_texture(draft));
  set_outline(&c, one_of_few_corners(draft, frame));
  map_across(draft, &c);
  Case elsewhere = c;
  map_anywhere(draft, &elsewhere);
  std::vector<selvage_vertex> repeated;
  for (size_t k = 0; k < c.vertices.size(); ++k) {
    const int copies = draft.random.in(2, 5);
    for (int copy = 0; copy < copies; ++copy) {
      const bool strange = !draft.whole_px && copy > 0 && draft.random.percent(40);
      repeated.push_back(strange ? elsewhere.vertices[k] : c.vertices[k]);
    }
  }
  c.vertices = std::move(repeated);
  return c;
}

namespace {

// The point k / parts of the way from a to b, each of whose coordinates is that much apart.
[[nodiscard]] selvage_vertex between(const selvage_vertex& a, const selvage_vertex& b, int32_t k,
                                     int32_t parts) {
  const auto mix = [=](int32_t from, int32_t to) { return from + (to - from) / parts * k; };
  return {mix(a.x, b.x), mix(a.y, b.y), mix(a.u, b.u), mix(a.v, b.v), a.q};
}

}  // namespace

// The runs divide each edge and its texture coordinates exactly, so they are to change nothing.
Case make_collinear_runs(uint64_t seed) {
  Draft draft(seed);
  const Frame frame = screen(draft);
  Case c = start(draft, frame, screen_texture(draft));
  const int32_t parts = draft.whole_px ? 4 : 12;
  set_outline(&c, quadrilateral(draft.random, frame, parts * draft.grid_fx8()));
  map_across(draft, &c);
  for (selvage_vertex& corner : c.vertices) {
    corner.u -= corner.u % parts;
    corner.v -= corner.v % parts;
  }
  std::vector<selvage_vertex> divided;
  for (size_t corner = 0; corner < c.vertices.size(); ++corner) {
    const selvage_vertex& from = c.vertices[corner];
    const selvage_vertex& to = c.vertices[(corner + 1) % c.vertices.size()];
    divided.push_back(from);
    for (int32_t k = 1; k < parts; ++k) {
      const bool is_middle = 2 * k == parts;
      if (is_middle || draft.random.percent(60)) divided.push_back(between(from, to, k, parts));
    }
  }
  c.vertices = std::move(divided);
  return c;
}

namespace {

// The top on a whole pixel, or on a row of centres, beside it, or anywhere.
[[nodiscard]] int64_t top_fx8(Draft& draft, Frame frame) {
  const int32_t row_fx8 = kPixel_fx8 * draft.random.in(0, frame.height_px / 4);
  const int32_t anywhere = draft.random.in(0, kPixel_fx8);
  const int32_t part = draft.random.pick(
      {kHalfPixel_fx8, kHalfPixel_fx8, kHalfPixel_fx8 - 1, kHalfPixel_fx8 + 1, anywhere});
  return draft.whole_px ? row_fx8 : row_fx8 + part;
}

// A horizontal run of two to five vertices on top, and one or two corners below of unequal height.
[[nodiscard]] Outline with_flat_top(Draft& draft, Frame frame) {
  Outline outline = quadrilateral(draft.random, frame, draft.grid_fx8());
  const int64_t top = top_fx8(draft, frame);
  outline[0].y = outline[1].y = top;
  if (outline[2].y == outline[3].y) outline[3].y -= kPixel_fx8;
  if (draft.random.percent(40)) outline.erase(outline.begin() + draft.random.in(2, 4));
  const int run = draft.random.in(0, 4);
  for (int k = 0; k < run; ++k) {
    const int64_t left = outline[static_cast<size_t>(k)].x;
    const int64_t right = outline[static_cast<size_t>(k) + 1].x;
    const int64_t place = left + (right - left) / 2 / draft.grid_fx8() * draft.grid_fx8();
    outline.insert(outline.begin() + k + 1, {place, top});
  }
  return outline;
}

}  // namespace

Case make_flat_topped(uint64_t seed) {
  Draft draft(seed);
  const Frame frame = screen(draft);
  Case c = start(draft, frame, screen_texture(draft));
  set_outline(&c, with_flat_top(draft, frame));
  map_across(draft, &c);
  return c;
}

Case make_flat_bottomed(uint64_t seed) {
  Case c = make_flat_topped(seed);
  for (selvage_vertex& v : c.vertices) v.y = c.target_height_px * kPixel_fx8 - v.y;
  return c;
}

namespace {

// Directions within a quarter turn, from right to short of down.
constexpr Point kQuarter[] = {{1, 0}, {5, 1}, {4, 1}, {7, 2}, {3, 1}, {5, 2}, {2, 1}, {5, 3},
                              {3, 2}, {7, 5}, {4, 3}, {5, 4}, {1, 1}, {4, 5}, {3, 4}, {5, 7},
                              {2, 3}, {3, 5}, {1, 2}, {2, 5}, {1, 3}, {2, 7}, {1, 4}, {1, 5}};
constexpr size_t kHalfTurnDirections = 2 * std::size(kQuarter);

// Of the directions in half a turn, from right to short of left.
[[nodiscard]] Point direction(size_t index) {
  if (index < std::size(kQuarter)) return kQuarter[index];
  const Point p = kQuarter[index - std::size(kQuarter)];
  return {-p.y, p.x};
}

// So many of them, in order, and then the same ones backward: around a convex outline.
[[nodiscard]] Outline round_trip(Random& random, size_t half_count) {
  std::vector<Point> steps;
  for (size_t index = 0; steps.size() < half_count; ++index) {
    const size_t wanted = half_count - steps.size();
    if (random.below(kHalfTurnDirections - index) < wanted) steps.push_back(direction(index));
  }
  Outline outline;
  Point at{0, 0};
  for (const int64_t sign : {1, -1}) {
    for (const Point& step : steps) {
      outline.push_back(at);
      at = at + sign * step;
    }
  }
  return outline;
}

// Strictly convex, all corners distinct, about as large as the frame; on whole pixels perhaps
// larger.
[[nodiscard]] Outline convex_ngon(Draft& draft, Frame frame, size_t corners) {
  Outline outline = round_trip(draft.random, (corners + 1) / 2);
  const auto [left, right] = std::ranges::minmax(outline, {}, &Point::x);
  const auto [top, bottom] = std::ranges::minmax(outline, {}, &Point::y);
  const Point least{left.x, top.y}, size{right.x - left.x, bottom.y - top.y};
  const auto largest = [&](int64_t unit_fx8) {
    return std::min(frame.width_px * kPixel_fx8 / unit_fx8 / size.x,
                    frame.height_px * kPixel_fx8 / unit_fx8 / size.y);
  };
  const int64_t grid = draft.grid_fx8();
  const int64_t scale = std::max<int64_t>(1, largest(grid)) * grid;
  const auto room = [&](int32_t frame_px, int64_t extent) {
    const int64_t rest = (frame_px * kPixel_fx8 - scale * extent) / grid;
    return draft.random.in(std::min<int64_t>(0, rest), std::max<int64_t>(0, rest) + 1) * grid;
  };
  const int64_t x = room(frame.width_px, size.x);
  const int64_t y = room(frame.height_px, size.y);
  for (Point& p : outline) p = Point{x, y} + scale * (p - least);
  if (corners % 2 == 1)
    outline.erase(outline.begin() + draft.random.in(0, static_cast<int64_t>(outline.size())));
  return outline;
}

}  // namespace

Case make_unrelated_ngon(uint64_t seed) {
  Draft draft(seed);
  const Frame frame = screen(draft);
  Case c = start(draft, frame, screen_texture(draft));
  const size_t corners = 5 + draft.random.below(8);
  set_outline(&c, convex_ngon(draft, frame, corners));
  map_anywhere(draft, &c);
  return c;
}

Case make_64_gon(uint64_t seed) {
  Draft draft(seed);
  const Frame frame = screen(draft);
  Case c = start(draft, frame, screen_texture(draft));
  set_outline(&c, convex_ngon(draft, frame, 64));
  map_across(draft, &c);
  return c;
}

}  // namespace selvage::spec
