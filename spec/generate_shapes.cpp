#include "spec/generate_shapes.h"

#include <algorithm>
#include <cstdlib>
#include <numeric>

#include "selvage.h"
#include "spec/case.h"
#include "spec/generate_near_ties.h"
#include "spec/shape_families.h"
#include "spec/vertex_units.h"

namespace selvage::spec {
namespace {

constexpr Weighted<Family> kOutlineFamilies[] = {
    {11, triangle}, {11, grid_triangle}, {7, sliver},  {2, smallest}, {5, needle},
    {8, rectangle}, {8, slanted},        {16, convex}, {14, chains},  {3, flat},
    {9, far_off},   {6, broken},         {1, too_few}, {10, grazing}};

using Index = std::ptrdiff_t;

[[nodiscard]] Index random_index(Random& random, const Outline& outline) {
  return static_cast<Index>(random.below(outline.size()));
}

void repeat_a_vertex(Random& random, const Frame&, Outline& outline) {
  const Index at = random_index(random, outline);
  const Point again = outline[static_cast<size_t>(at)];
  outline.insert(outline.begin() + at, 1 + random.below(3), again);
}

// The way from a vertex to the next one by an edge of up to 1/16 px high, over a row of centres.
void add_a_low_edge(Random& random, const Frame& frame, Index at, Outline& outline) {
  const Point from = outline[static_cast<size_t>(at)];
  const Point to = outline[static_cast<size_t>(at + 1) % outline.size()];
  const int64_t top = std::min(from.y, to.y), bottom = std::max(from.y, to.y);
  const int64_t centre = (random.in(top, bottom + 1) & ~(kPixel_fx8 - 1)) + kHalfPixel_fx8;
  const int64_t height = random.in(1, 17), above = random.in(0, height);
  Point upper{position_fx8(random, frame.width_px), centre - above};
  Point lower{position_fx8(random, frame.width_px), upper.y + height};
  if (upper.y < top || lower.y > bottom) return;  // it would turn back
  if (to.y < from.y) std::swap(upper, lower);
  outline.insert(outline.begin() + at + 1, {upper, lower});
}

// A horizontal step out of a vertex; back again, or not. Or one that is not quite horizontal.
void add_a_ledge(Random& random, const Frame& frame, Outline& outline) {
  const Index at = random_index(random, outline);
  const Point from = outline[static_cast<size_t>(at)];
  if (random.percent(30)) return add_a_low_edge(random, frame, at, outline);
  const Point to{position_fx8(random, frame.width_px), from.y};
  outline.insert(outline.begin() + at, to);
  if (random.percent(40)) outline.insert(outline.begin() + at, from);
}

// Vertices on an edge, at equal distances, as far as the grid has any there.
void add_a_collinear_run(Random& random, const Frame&, Outline& outline) {
  const Index at = random_index(random, outline);
  const Point to = outline[static_cast<size_t>(at)];
  const Point from = at == 0 ? outline.back() : outline[static_cast<size_t>(at - 1)];
  const Point way{to.x - from.x, to.y - from.y};
  const int64_t places = std::gcd(way.x, way.y);
  if (places < 2) return;
  const int64_t parts = std::min<int64_t>(places, 2 + random.in(0, 3));
  Outline run;
  for (int64_t part = 1; part < parts; ++part) {
    const int64_t place = places * part / parts;
    run.push_back({from.x + way.x / places * place, from.y + way.y / places * place});
  }
  outline.insert(outline.begin() + at, run.begin(), run.end());
}

void shift(Random& random, const Frame& frame, Outline& outline) {
  const int32_t unit_fx8 = random.pick({kPixel_fx8, kHalfPixel_fx8, 1});
  const auto distance_fx8 = [&](int32_t size_px) {
    const int64_t most = int64_t{size_px + 1} * kPixel_fx8 / unit_fx8;
    return random.percent(40) ? 0 : unit_fx8 * random.in(-most, most + 1);
  };
  const Point distance{distance_fx8(frame.width_px), distance_fx8(frame.height_px)};
  for (Point& point : outline) point = {point.x + distance.x, point.y + distance.y};
}

// About the middle of the target, so that more of it is covered and more is cut off.
void enlarge(Random& random, const Frame& frame, Outline& outline) {
  const int64_t factor = random.in(2, 4);
  const Point middle{frame.width_px * kHalfPixel_fx8, frame.height_px * kHalfPixel_fx8};
  for (Point& point : outline) {
    point = {middle.x + (point.x - middle.x) * factor, middle.y + (point.y - middle.y) * factor};
  }
}

// One axis from its least and greatest position to the ends of the target. Order is kept.
void stretch_axis(int64_t Point::*axis, int32_t size_px, Outline& outline) {
  const auto before = [=](const Point& a, const Point& b) { return a.*axis < b.*axis; };
  const auto [least, greatest] = std::minmax_element(outline.begin(), outline.end(), before);
  const int64_t first = (*least).*axis;
  const int64_t extent = (*greatest).*axis - first;
  if (extent == 0) return;
  for (Point& point : outline) {
    point.*axis = (point.*axis - first) * size_px * kPixel_fx8 / extent;
  }
}

void stretch(Random& random, const Frame& frame, Outline& outline) {
  if (random.percent(80)) stretch_axis(&Point::x, frame.width_px, outline);
  if (random.percent(80)) stretch_axis(&Point::y, frame.height_px, outline);
}

using Change = void (*)(Random&, const Frame&, Outline&);
struct Likely {
  int percent;
  Change change;
};
constexpr Likely kChanges[] = {{25, stretch},         {8, enlarge},      {8, shift},
                               {12, repeat_a_vertex}, {12, add_a_ledge}, {10, add_a_collinear_run}};

}  // namespace

Outline random_outline(Random& random, const Frame& frame) {
  const Family family = choose<Family>(random, kOutlineFamilies);
  Outline outline = family(random, frame);
  if (outline.size() < 3) return outline;
  for (const Likely& likely : kChanges) {
    if (random.percent(likely.percent)) likely.change(random, frame, outline);
  }
  if (random.percent(50)) std::reverse(outline.begin(), outline.end());
  const Index first = random_index(random, outline);
  std::rotate(outline.begin(), outline.begin() + first, outline.end());
  for (Point& point : outline) point = {clamped_position(point.x), clamped_position(point.y)};
  return outline;
}

}  // namespace selvage::spec
