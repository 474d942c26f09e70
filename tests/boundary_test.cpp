#include "mapper/boundary.h"

#include <gtest/gtest.h>

#include <optional>

#include "mapper/plane.h"
#include "mapper/projective_plane.h"
#include "spec/generate.h"
#include "spec/random.h"
#include "tests/span_support.h"
#include "tests/whole.h"

namespace selvage::mapper {
namespace {

struct BoundaryCounts {
  int before = 0, beyond = 0, crossed = 0, unknown = 0;
};

// What a boundary says of some pixels is what the exact map does.
void expect_right(const ExactMap& map, ExactLine ExactRow::*coordinate, int bits, int32_t whole,
                  const Boundary& boundary, const Span& pixels, BoundaryCounts* seen) {
  const Boundary::Sides sides = boundary.sides_of(pixels);
  if (sides.left_px < 0) {
    ++seen->unknown;
    return;
  }
  ASSERT_GT(sides.left_px, 0);
  const ExactRow row = map.row_from(pixels.left_px, pixels.row);
  const ExactLine d = row.finer_d(bits);
  for (int32_t i = 0; i < pixels.width_px(); ++i) {
    const bool is_left = i < sides.left_px;
    ASSERT_EQ(reaches((row.*coordinate).at(i), d.at(i), whole), is_left == sides.left_beyond);
  }
  ++(sides.left_px < pixels.width_px() ? seen->crossed
     : sides.left_beyond               ? seen->beyond
                                       : seen->before);
}

// Boundaries of texels and of the filters' grid, found in one row and asked for in others.
void check_rows(const ExactMap& map, const std::vector<Span>& rows, spec::Random& random,
                BoundaryCounts* seen) {
  for (const auto coordinate : {&ExactRow::u, &ExactRow::v}) {
    const int bits = random.pick({0, 8});
    const Span& known = rows[static_cast<size_t>(random.in(0, static_cast<int>(rows.size())))];
    const ExactRow row = map.row_from(known.left_px, known.row);
    const auto n = static_cast<int128>((row.*coordinate).start);
    const auto d = static_cast<int128>(row.finer_d(bits).start);
    const auto whole = static_cast<int32_t>(floor_of(n, d)) + random.in(-1, 2);
    const Boundary boundary(map, coordinate, bits, whole, known.left_px, known.row);
    for (const Span& span : rows) {
      expect_right(map, coordinate, bits, whole, boundary, span, seen);
    }
  }
}

TEST(Boundary, HasPixelsOnTheSideThatItSays) {
  BoundaryCounts seen;
  for (uint64_t seed = 1; seed <= 4000; ++seed) {
    const spec::Case c = spec::generate(seed);
    spec::Random random(seed);
    Polygon polygon;
    if (examine(c.vertices, &polygon) != SELVAGE_OK) continue;
    std::vector<Span> rows;
    for_each_span(c, [&](const spec::Case&, const Polygon&, const SpanMap& map, const Span& span) {
      rows.push_back(span);
      if (rows.size() <= 2) check_rows(ExactMap(map), {span}, random, &seen);
    });
    if (rows.empty()) continue;
    const selvage_rect visible{-2, 0, c.target_width_px + 2, c.target_height_px};
    if (polygon.affine) {
      const auto plane = Plane::of(polygon, part_of(polygon, visible));
      if (plane) check_rows(ExactMap(*plane), rows, random, &seen);
    } else if (const auto plane = ProjectivePlane::of(polygon, visible)) {
      check_rows(ExactMap(*plane), rows, random, &seen);
    }
  }
  EXPECT_GT(seen.before, 3000);
  EXPECT_GT(seen.beyond, 3000);
  EXPECT_GT(seen.crossed, 300);
  EXPECT_LT(seen.unknown, (seen.before + seen.beyond) / 10);
}

// u is whole at all pixels: they are at the boundary, and beyond the one before.
TEST(Boundary, IsReachedByTies) {
  const std::vector<selvage_vertex> triangle = {
      {0, 0, 5 << 16, 0, 1}, {25600, 0, 5 << 16, 0, 1}, {0, 25600, 5 << 16, 65536, 1}};
  Polygon polygon;
  ASSERT_EQ(examine(triangle, &polygon), SELVAGE_OK);
  const auto plane = Plane::of(polygon, {0, 0, 100, 100});
  ASSERT_TRUE(plane);
  const Span pixels{7, 3, 40};
  for (const int32_t whole : {4, 5, 6}) {
    const auto sides = Boundary(ExactMap(*plane), &ExactRow::u, 0, whole, 0, 0).sides_of(pixels);
    EXPECT_EQ(sides.left_px, pixels.width_px());
    EXPECT_EQ(sides.left_beyond, whole <= 5);
  }
}

// u is whole along a diagonal, and greater to its right. The terms there are longer than a double,
// and cancel to what tells nothing: of one pixel, of the last of some, and of one between them.
TEST(Boundary, IsUncertainWhereRoundingsDecide) {
  spec::Random random(1);
  int uncertain = 0, uncertain_last = 0, uncertain_between = 0;
  for (int i = 0; i < 200; ++i) {
    const int32_t side_fx8 = random.in(20000, 30000) * SELVAGE_SUBPIXELS;
    const int32_t rise_fx16 = random.in(1, 1 << 24), q = random.in(1 << 23, 1 << 24);
    const std::vector<selvage_vertex> triangle = {{0, 0, 5 << 16, 0, SELVAGE_Q_MAX - 1},
                                                  {side_fx8, 0, (5 << 16) + rise_fx16, 0, q},
                                                  {0, side_fx8, (5 << 16) - rise_fx16, 0, q}};
    Polygon polygon;
    ASSERT_EQ(examine(triangle, &polygon), SELVAGE_OK);
    const auto plane = ProjectivePlane::of(polygon, {0, 0, 9000, 9000});
    ASSERT_TRUE(plane);
    const Boundary boundary(ExactMap(*plane), &ExactRow::u, 0, 5, random.in(0, 9000),
                            random.in(0, 9000));
    for (int j = 0; j < 50; ++j) {
      const int32_t at = random.in(0, 9000);
      const auto sides = boundary.sides_of({at, at, at + 1});
      if (sides.left_px < 0) {
        ++uncertain;
      } else {
        ASSERT_TRUE(sides.left_beyond);
      }
      const auto last = boundary.sides_of({at, at - 50, at + 1});
      const auto between = boundary.sides_of({at, at - 50, at + 50});
      for (const auto& known : {last, between}) {
        ASSERT_TRUE(known.left_px < 0 || (known.left_px == 50 && !known.left_beyond));
      }
      uncertain_last += last.left_px < 0 ? 1 : 0;
      uncertain_between += between.left_px < 0 ? 1 : 0;
    }
  }
  EXPECT_GT(uncertain, 5000);
  EXPECT_GT(uncertain_last, 1000);
  EXPECT_GT(uncertain_between, 1000);
}

}  // namespace
}  // namespace selvage::mapper
