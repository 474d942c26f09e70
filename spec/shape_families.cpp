#include "spec/shape_families.h"

#include <algorithm>

#include "selvage.h"
#include "spec/generate_near_ties.h"
#include "spec/vertex_units.h"

namespace selvage::spec {
namespace {

constexpr int32_t kFirst_fx8 = SELVAGE_X_MIN, kLast_fx8 = SELVAGE_X_END - 1;

[[nodiscard]] Point random_position(Random& random, const Frame& frame) {
  return {position_fx8(random, frame.width_px), position_fx8(random, frame.height_px)};
}

[[nodiscard]] int32_t centre_fx8(Random& random, int32_t size_px) {
  return kPixel_fx8 * random.in(0, size_px) + kHalfPixel_fx8;
}

[[nodiscard]] Point plus(const Point& a, const Point& b) { return {a.x + b.x, a.y + b.y}; }

[[nodiscard]] Point times(const Point& a, int64_t factor) { return {a.x * factor, a.y * factor}; }

void transpose(Outline& outline) {
  for (Point& point : outline) point = {point.y, point.x};
}

// At an end of the accepted range, just inside it, or anywhere in it.
[[nodiscard]] int32_t far_fx8(Random& random) {
  const int32_t anywhere = random.in(kFirst_fx8, int64_t{kLast_fx8} + 1);
  return random.pick({kFirst_fx8, kLast_fx8, kFirst_fx8 + 1, kLast_fx8 - 1,
                      kFirst_fx8 + kHalfPixel_fx8, kLast_fx8 + 1 - kHalfPixel_fx8, anywhere,
                      anywhere});
}

[[nodiscard]] int32_t near_or_far_fx8(Random& random, int32_t size_px) {
  return random.percent(35) ? position_fx8(random, size_px) : far_fx8(random);
}

}  // namespace

int32_t position_fx8(Random& random, int32_t size_px) {
  const int32_t margin_px = random.percent(20) ? 3 : 0;
  const int32_t whole_fx8 = kPixel_fx8 * random.in(-margin_px, size_px + margin_px + 1);
  const int32_t anywhere_fx8 = random.in(0, kPixel_fx8);
  return whole_fx8 +
         random.pick({0, 0, kHalfPixel_fx8, kHalfPixel_fx8, 1, -1, kHalfPixel_fx8 - 1,
                      kHalfPixel_fx8 + 1, anywhere_fx8, anywhere_fx8, anywhere_fx8, anywhere_fx8});
}

int32_t grid_position_fx8(Random& random, int32_t size_px, int32_t step_fx8) {
  return step_fx8 * random.in(-1, int64_t{size_px} * kPixel_fx8 / step_fx8 + 2);
}

Outline triangle(Random& random, const Frame& frame) {
  return {random_position(random, frame), random_position(random, frame),
          random_position(random, frame)};
}

Outline grid_triangle(Random& random, const Frame& frame) {
  Outline outline(3);
  for (Point& point : outline) {
    point = {grid_position_fx8(random, frame.width_px, kHalfPixel_fx8),
             grid_position_fx8(random, frame.height_px, kHalfPixel_fx8)};
  }
  return outline;
}

Outline smallest(Random& random, const Frame& frame) {
  const int32_t reach_fx8 = kPixel_fx8 * (frame.width_px + frame.height_px) / 2;
  const auto [a, b] = random_neighbours(random, reach_fx8);
  const int32_t mirror = random.pick({1, -1});
  const Point start{centre_fx8(random, frame.width_px), centre_fx8(random, frame.height_px)};
  return {start, {start.x + a.x * mirror, start.y + a.y}, {start.x + b.x * mirror, start.y + b.y}};
}

// Two ends on pixel centres, so that the long edge runs through any centres between them.
Outline sliver(Random& random, const Frame& frame) {
  const Point from{centre_fx8(random, frame.width_px), centre_fx8(random, frame.height_px)};
  const Point to{centre_fx8(random, frame.width_px), centre_fx8(random, frame.height_px)};
  const int32_t part = random.in(-20, 121);
  const int32_t off_fx8 = random.pick({1, 1, 2, 16, 64, 128});
  const int32_t reach_fx8 = 2 * off_fx8 + 1;
  Point third{from.x + (to.x - from.x) * part / 100, from.y + (to.y - from.y) * part / 100};
  third = {third.x + random.in(0, reach_fx8) - off_fx8, third.y};
  third = {third.x, third.y + random.in(0, reach_fx8) - off_fx8};
  return {from, to, third};
}

Outline needle(Random& random, const Frame& frame) {
  const bool upright = random.percent(30);
  const int32_t length_px = upright ? frame.height_px : frame.width_px;
  const int32_t row_px = random.in(0, upright ? frame.width_px : frame.height_px);
  const int32_t top_fx8 = row_px * kPixel_fx8 + random.pick({0, 0, 1, 64, 127, 128});
  const int32_t height_fx8 = random.pick({1, 2, 64, 128, 129, 255, 256});
  const int32_t left_fx8 = random.pick({0, -kPixel_fx8, kHalfPixel_fx8, 1, -1});
  const int32_t right_fx8 = length_px * kPixel_fx8 + random.pick({0, kPixel_fx8, -128, -1, 1});
  Outline outline;
  outline.push_back({left_fx8, top_fx8 + random.in(0, height_fx8 + 1)});
  outline.push_back({right_fx8, top_fx8});
  outline.push_back({random.in(left_fx8, int64_t{right_fx8} + 1), top_fx8 + height_fx8});
  if (upright) transpose(outline);
  return outline;
}

Outline rectangle(Random& random, const Frame& frame) {
  const Point a = random_position(random, frame), b = random_position(random, frame);
  return {a, {b.x, a.y}, b, {a.x, b.y}};
}

Outline slanted(Random& random, const Frame& frame) {
  const int32_t step_fx8 = random.pick({kPixel_fx8, kHalfPixel_fx8, 64, 1});
  const int32_t reach_px = std::max(frame.width_px, frame.height_px);
  const int64_t most = int64_t{reach_px} * kPixel_fx8 / step_fx8 / 2 + 2;
  const Point slope =
      random.pick({Point{1, 1}, Point{3, 1}, Point{1, 3}, Point{2, 1}, Point{1, 2}});
  const Point other = random.pick({Point{-1, 1}, Point{-3, 1}, Point{-1, 3}, Point{1, 0},
                                   Point{0, 1}, Point{-slope.x, slope.y}});
  const Point start{grid_position_fx8(random, frame.width_px, kHalfPixel_fx8),
                    grid_position_fx8(random, frame.height_px, kHalfPixel_fx8)};
  const Point along = times(slope, step_fx8 * random.in(1, most));
  const Point across = times(other, step_fx8 * random.in(1, most));
  return {start, plus(start, along), plus(plus(start, along), across), plus(start, across)};
}

Outline flat(Random& random, const Frame& frame) {
  const Point start = random_position(random, frame);
  const Point step{random.in(-600, 601), random.in(0, 601)};
  const Point direction = random.pick(
      {Point{0, 0}, Point{step.x, 0}, Point{0, step.y}, step, Point{kPixel_fx8, kPixel_fx8}});
  const size_t length = 2 + random.below(4);
  Outline outline;
  for (size_t i = 0; i < length; ++i) {
    const Point next = plus(start, times(direction, static_cast<int64_t>(i)));
    const bool bent = direction.y > 0 && random.percent(20);
    outline.push_back(bent ? plus(next, {kPixel_fx8, 0}) : next);
  }
  for (size_t i = length; i-- > 0;) {  // and back over the same points
    const Point back = outline[i];
    outline.push_back(back);
  }
  return outline;
}

Outline far_off(Random& random, const Frame& frame) {
  Outline outline(3);
  for (Point& point : outline) {
    point = {near_or_far_fx8(random, frame.width_px), near_or_far_fx8(random, frame.height_px)};
  }
  const int kind = random.in(0, 4);
  if (kind == 0) return outline;
  if (kind == 1) {  // a rectangle
    const Point a = outline[0], b = outline[1];
    return {a, {b.x, a.y}, b, {a.x, b.y}};
  }
  // An edge through a point of the target: its ends lie opposite to each other.
  const Point middle = random_position(random, frame);
  outline[0] = {far_fx8(random), far_fx8(random)};
  if (kind == 2) outline[0].y = middle.y + random.in(-kPixel_fx8, kPixel_fx8);
  outline[1] = {2 * middle.x - outline[0].x, 2 * middle.y - outline[0].y};
  return outline;
}

Outline broken(Random& random, const Frame& frame) {
  Outline outline(4 + random.below(9));
  for (size_t i = 0; i < outline.size(); ++i) {
    outline[i] = random_position(random, frame);
    if (random.percent(70)) outline[i].y += i % 2 == 0 ? -kPixel_fx8 : kPixel_fx8;
  }
  return outline;
}

Outline too_few(Random& random, const Frame& frame) {
  Outline outline(random.below(3));
  for (Point& point : outline) point = random_position(random, frame);
  return outline;
}

}  // namespace selvage::spec
