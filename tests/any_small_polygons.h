// Lists of triangles and parallelograms that are small, or hardly larger: needles, ties, and depths
// at their limits.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "mapper/polygon.h"
#include "spec/random.h"
#include "spec/vertex_units.h"
#include "tests/any_surfaces.h"
#include "tests/small_support.h"

namespace selvage::mapper {

[[nodiscard]] inline bool is_small_drawable(const SmallOutline& outline) {
  Polygon polygon;
  return examine(outline, &polygon) == SELVAGE_OK;
}

[[nodiscard]] inline spec::Case any_small_case(spec::Random& random) {
  spec::Case c = any_surfaces(random);
  if (random.percent(10) && c.format == SELVAGE_RGBA8888) {
    c.filter = random.pick({SELVAGE_FILTER_BILINEAR, SELVAGE_FILTER_FOUR, SELVAGE_FILTER_AREA});
  }
  c.target_width_px = random.in(1, 60);
  c.target_height_px = random.in(1, 60);
  c.texture_width_texel = random.pick({1, 7, 8, 9, 15, 16, 17, 33, 100});
  c.texture_height_texel = random.pick({1, 3, 4, 7, 8, 9, 11, 12, 13, 33, 100});
  c.padding_px = random.in(0, 4);
  c.has_clip = random.percent(30);
  const int32_t left = random.in(-5, 50), top = random.in(-5, 50);
  c.clip = {left, top, left + random.in(1, 40), top + random.in(1, 40)};
  return c;
}

// Of hardly an area, so thin that u and v may run by more than lanes can tell: about a pixel's
// centre, the only point of the grid in it, or with one for a corner.
[[nodiscard]] inline SmallOutline any_needle(spec::Random& random, const spec::Case& c) {
  const int32_t x = random.in(0, c.target_width_px) * spec::kPixel_fx8 + spec::kPixel_fx8 / 2,
                y = random.in(0, c.target_height_px) * spec::kPixel_fx8 + spec::kPixel_fx8 / 2;
  const int32_t along = random.in(1, 8 * spec::kPixel_fx8 - 2);
  const int32_t right = random.pick({1, -1}), down = random.pick({1, -1});
  SmallOutline needle{{-along, 1 - along, 0, 0, 1}, {-1, -1, 0, 0, 1}, {along + 1, along, 0, 0, 1}};
  const int32_t across = random.in(1, 8 * spec::kPixel_fx8 - 2);
  const int64_t back = inverse(across, along);
  if (back != 0 && random.percent(50)) {
    const int64_t doubled_area = random.in(1, random.pick({4, 8, 8, 30}));
    const int64_t dy = doubled_area * back % along, dx = (across * dy - doubled_area) / along;
    needle = {{0, 0, 0, 0, 1},
              {across, along, 0, 0, 1},
              {static_cast<int32_t>(dx) - across, static_cast<int32_t>(dy) - along, 0, 0, 1}};
  }
  for (selvage_vertex& vertex : needle) {
    vertex.x = x + right * vertex.x;
    vertex.y = y + down * vertex.y;
  }
  return needle;
}

// Up to the greatest that may be small, and a little beyond; on pixels' centres or anywhere.
[[nodiscard]] inline SmallOutline any_small_outline(spec::Random& random, const spec::Case& c) {
  const int32_t most_px = random.pick({1, 3, 8, 16, 17});
  const int32_t x = random.in(-4, c.target_width_px) * spec::kPixel_fx8 + random.pick({0, 128}),
                y = random.in(-4, c.target_height_px) * spec::kPixel_fx8 + random.pick({0, 128});
  const int32_t grid_fx8 = random.pick({1, 1, spec::kPixel_fx8 / 2, spec::kPixel_fx8});
  SmallOutline triangle(3);
  for (selvage_vertex& vertex : triangle) {
    const auto near = [&](int32_t from_fx8) {
      const int32_t by_fx8 = random.in(0, most_px * spec::kPixel_fx8 + 1);
      return from_fx8 + by_fx8 / grid_fx8 * grid_fx8;
    };
    vertex = {near(x), near(y), 0, 0, 1};
  }
  if (random.percent(10)) triangle[2].y = triangle[random.percent(50) ? 0 : 1].y;
  // Hardly an area, or none.
  if (random.percent(10)) {
    triangle[2].x = (triangle[0].x + triangle[1].x) / 2 + random.in(-1, 2);
    triangle[2].y = (triangle[0].y + triangle[1].y) / 2 + random.in(-1, 2);
  }
  return triangle;
}

// A coordinate anywhere in some texels of the texture or beside it; or what hardly leaves the
// beginning of a texel, so that many pixels are near-ties; or the pixels' own, scaled; or one that
// is the beginning of a texel along an edge, and nowhere less.
inline void set_any_texels(spec::Random& random, int32_t size_texel, int32_t selvage_vertex::*place,
                           int32_t selvage_vertex::*texel, SmallOutline* outline) {
  const int32_t most_texel = random.pick({1, 2, 4, 5, 8, 9, 12, 16, 20, 64, 70});
  const int32_t first = random.percent(80) ? random.in(0, std::max(1, size_texel - most_texel + 1))
                                           : random.in(-3, size_texel + 3);
  const int32_t from_fx16 = first * spec::kTexel_fx16;
  const int32_t kind = random.in(0, 5), steepest = random.pick({128, 512, 2000});
  const int32_t per_px = random.in(-steepest, steepest + 1);
  const int32_t divisor = random.pick({1, 3, 5, 7});
  const size_t raised = random.below(outline->size());
  const int32_t first_fx8 = outline->front().*place;
  for (size_t i = 0; i < outline->size(); ++i) {
    selvage_vertex& vertex = (*outline)[i];
    int32_t& value = vertex.*texel;
    value = from_fx16;
    if (kind == 0) value += random.in(0, most_texel * spec::kTexel_fx16);
    if (kind == 1) value += spec::kTexel_fx16 - random.in(0, 3);
    if (kind == 2) value += random.in(0, most_texel) * spec::kTexel_fx16;
    if (kind == 3) value += (vertex.*place - first_fx8) * per_px / divisor;
    if (kind == 4 && i == raised) {
      value += random.in(0, std::min(most_texel, size_texel) * spec::kTexel_fx16);
    }
  }
}

// A parallelogram of a triangle, so that both lie in one plane.
inline void add_fourth(SmallOutline* outline) {
  const selvage_vertex &a = (*outline)[0], &b = (*outline)[1], &c = (*outline)[2];
  outline->push_back({a.x - b.x + c.x, a.y - b.y + c.y, a.u - b.u + c.u, a.v - b.v + c.v, 1});
}

// All equal; or up to four times as great as the least, or hardly more: whole numbers of it, of
// which many quotients are whole, or any.
inline void set_any_depths(spec::Random& random, SmallOutline* outline) {
  const int32_t least = random.pick({1, 1, 2, 3, 1000, random.in(1, 1 << 22), (1 << 22) - 1});
  const int32_t kind = random.in(0, 4);
  for (selvage_vertex& vertex : *outline) {
    vertex.q = least;
    if (kind == 1) vertex.q *= random.in(1, 5);
    if (kind == 2) vertex.q = random.in(least, 4 * least + 2);
    if (kind == 3) vertex.q += random.in(0, least / 64 + 2);
  }
}

// u and v as the depths' reciprocals are: u q and v q are the same everywhere.
inline void set_inverse_texels(spec::Random& random, int32_t size_texel,
                               int32_t selvage_vertex::*texel, SmallOutline* outline) {
  const int64_t least = std::ranges::min(*outline, {}, &selvage_vertex::q).q;
  const int64_t most_fx16 = random.in(1, std::min(size_texel, 8) * spec::kTexel_fx16);
  for (selvage_vertex& vertex : *outline) {
    vertex.*texel = static_cast<int32_t>(most_fx16 * least / vertex.q);
  }
}

[[nodiscard]] inline std::vector<SmallOutline> any_small_outlines(spec::Random& random,
                                                                  const spec::Case& c) {
  std::vector<SmallOutline> outlines(static_cast<size_t>(random.in(1, 40)));
  for (SmallOutline& outline : outlines) {
    do {
      outline = random.percent(15) ? any_needle(random, c) : any_small_outline(random, c);
      set_any_texels(random, c.texture_width_texel, &selvage_vertex::x, &selvage_vertex::u,
                     &outline);
      set_any_texels(random, c.texture_height_texel, &selvage_vertex::y, &selvage_vertex::v,
                     &outline);
      if (random.percent(25)) add_fourth(&outline);
    } while (!is_small_drawable(outline));
    set_any_depths(random, &outline);
    if (random.percent(10)) {
      set_inverse_texels(random, c.texture_width_texel, &selvage_vertex::u, &outline);
      set_inverse_texels(random, c.texture_height_texel, &selvage_vertex::v, &outline);
    }
  }
  return outlines;
}

}  // namespace selvage::mapper
