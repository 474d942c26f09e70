#include "mapper/slab.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "mapper/span_walk.h"
#include "spec/generate.h"
#include "spec/random.h"
#include "tests/slab_support.h"

namespace selvage::mapper {
namespace {

[[nodiscard]] selvage_rect bounding_rect(const Polygon& polygon) {
  return {polygon.left_px, polygon.top_row, polygon.right_px, polygon.bottom_row};
}

[[nodiscard]] std::vector<Slab> slabs_of(const Polygon& polygon, const selvage_rect& part) {
  std::vector<Slab> slabs;
  SlabWalk walk(polygon, part);
  while (const auto slab = walk.next()) slabs.push_back(*slab);
  return slabs;
}

// Every row is in one slab, between the edges that cross it.
TEST(Slabs, TileTheVisibleRows) {
  int clipped = 0, several = 0;
  for (uint64_t seed = 1; seed <= 3000; ++seed) {
    const spec::Case c = spec::generate(seed);
    Polygon polygon;
    if (examine(c.vertices, &polygon) != SELVAGE_OK) continue;
    spec::Random random(seed);
    selvage_rect part = bounding_rect(polygon);
    part.bottom = std::min(part.bottom, part.top + 300);
    if (part.top >= part.bottom) continue;
    if (random.percent(50)) part.top += random.in(0, part.bottom - part.top);
    clipped += part.top != polygon.top_row;
    const auto slabs = slabs_of(polygon, part);
    several += slabs.size() > 1;
    int32_t row = part.top;
    Chain forward(polygon, Chain::Direction::kForward);
    Chain backward(polygon, Chain::Direction::kBackward);
    for (const Slab& slab : slabs) {
      ASSERT_EQ(slab.first_row, row) << seed;
      ASSERT_GT(slab.rows(), 0);
      for (; row < slab.end_row; ++row) {
        ASSERT_EQ(&slab.a.top(), &forward.at_row(row).top()) << seed;
        ASSERT_EQ(&slab.a.bottom(), &forward.at_row(row).bottom());
        ASSERT_EQ(&slab.b.top(), &backward.at_row(row).top());
        ASSERT_EQ(&slab.b.bottom(), &backward.at_row(row).bottom());
      }
    }
    ASSERT_EQ(row, part.bottom) << seed;
  }
  EXPECT_GT(clipped, 500);
  EXPECT_GT(several, 1000);
}

TEST(Slabs, KnowTheMostThatTheirDenominatorsAre) {
  int rows = 0;
  double most_share = 0;
  for_each_slab(2000, true, [&](const auto&, const Polygon& polygon, const Slab& slab) {
    const RuledMap map(slab);
    SpanWalk walk(polygon, {-40000, slab.first_row, 40000, slab.end_row});
    const double most = map.most_denominator() * (1 + 0x1p-40);
    for (int32_t i = 0; i < 200 && walk.next(); ++i) {
      const auto d = static_cast<double>(map.at(walk.span().row).denominator(walk.span().left_px));
      ASSERT_LE(d, most);
      most_share = std::max(most_share, d / most);
      ++rows;
    }
  });
  EXPECT_GT(rows, 50000);
  EXPECT_GT(most_share, 0.9);
}

// The rows of a slab's outline are those of the polygon.
TEST(Slabs, HaveOutlinesWithTheSameSpans) {
  size_t triangles = 0, quads = 0;
  for (uint64_t seed = 1; seed <= 2000; ++seed) {
    const spec::Case c = spec::generate(seed);
    Polygon polygon;
    if (examine(c.vertices, &polygon) != SELVAGE_OK || polygon.bottom_row - polygon.top_row > 300)
      continue;
    SpanWalk spans(polygon, bounding_rect(polygon));
    for (const Slab& slab : slabs_of(polygon, bounding_rect(polygon))) {
      const SlabOutline corners_of(slab);
      const Polygon outline = corners_of.polygon();
      const size_t corners = outline.vertices.size();
      (corners == 3 ? triangles : quads) += 1;
      if (corners == 0) {  // both edges are one
        EXPECT_FALSE(spans.next_above(slab.end_row)) << seed;
        continue;
      }
      SpanWalk own(outline, {polygon.left_px, slab.first_row, polygon.right_px, slab.end_row});
      while (spans.next_above(slab.end_row)) {
        ASSERT_TRUE(own.next()) << seed;
        ASSERT_EQ(own.span().row, spans.span().row) << seed;
        ASSERT_EQ(own.span().left_px, spans.span().left_px);
        ASSERT_EQ(own.span().right_px, spans.span().right_px);
      }
      ASSERT_FALSE(own.next()) << seed;
    }
  }
  EXPECT_GT(triangles, 1000U);
  EXPECT_GT(quads, 300U);
}

TEST(Slabs, AreTrianglesWhereTheirEdgesMeet) {
  // A square on its corner, a little uneven: a triangle, a quad, a triangle.
  const std::vector<selvage_vertex> vertices = {{0, -5000, 0, 0, 1},
                                                {5000, 40, 1 << 20, 0, 1},
                                                {10, 5000, 1 << 20, 1 << 20, 1},
                                                {-5000, 1300, 0, 1 << 20, 1}};
  Polygon polygon;
  ASSERT_EQ(examine(vertices, &polygon), SELVAGE_OK);
  std::vector<size_t> corners;
  for (const Slab& slab : slabs_of(polygon, bounding_rect(polygon)))
    corners.push_back(SlabOutline(slab).polygon().vertices.size());
  EXPECT_EQ(corners, (std::vector<size_t>{3, 4, 3}));
}

// `skip_to` leaves out rows, and what comes after them is unchanged.
TEST(Slabs, MayBeSkippedByAWalkOverAllRows) {
  for (uint64_t seed = 1; seed <= 1000; ++seed) {
    const spec::Case c = spec::generate(seed);
    Polygon polygon;
    if (examine(c.vertices, &polygon) != SELVAGE_OK || polygon.bottom_row - polygon.top_row > 300)
      continue;
    SpanWalk every(polygon, bounding_rect(polygon)), some(polygon, bounding_rect(polygon));
    bool skipped = false;
    for (const Slab& slab : slabs_of(polygon, bounding_rect(polygon))) {
      skipped = !skipped;
      if (skipped) {
        while (every.next_above(slab.end_row)) {
        }
        some.skip_to(slab.end_row);
        continue;
      }
      while (every.next_above(slab.end_row)) {
        ASSERT_TRUE(some.next_above(slab.end_row)) << seed;
        ASSERT_EQ(some.span().row, every.span().row) << seed;
        ASSERT_EQ(some.span().left_px, every.span().left_px) << seed;
        ASSERT_EQ(some.span().right_px, every.span().right_px) << seed;
      }
      ASSERT_FALSE(some.next_above(slab.end_row)) << seed;
    }
  }
}

[[nodiscard]] Slab between(const selvage_vertex (&v)[4], int32_t rows) {
  return {Edge(v[0], v[1]), Edge(v[2], v[3]), 0, rows};
}

TEST(Slabs, RunFromLeftToRightUnlessTheirEdgesCross) {
  const int32_t down = 8 * 256;
  const selvage_vertex apart[] = {
      {0, 0, 0, 0, 1}, {0, down, 0, 0, 1}, {9, 0, 0, 0, 1}, {9, down, 0, 0, 1}};
  const auto same = from_left_to_right(between(apart, 8));
  ASSERT_TRUE(same);
  EXPECT_EQ(&same->a.top(), &apart[0]);
  const auto turned =
      from_left_to_right({Edge(apart[2], apart[3]), Edge(apart[0], apart[1]), 0, 8});
  ASSERT_TRUE(turned);
  EXPECT_EQ(&turned->a.top(), &apart[0]);
  EXPECT_EQ(turned->end_row, 8);
  // They cross between the first row and the last.
  const selvage_vertex crossing[] = {
      {0, 0, 0, 0, 1}, {9, down, 0, 0, 1}, {9, 0, 0, 0, 1}, {0, down, 0, 0, 1}};
  EXPECT_FALSE(from_left_to_right(between(crossing, 8)));
  EXPECT_FALSE(
      from_left_to_right({Edge(crossing[2], crossing[3]), Edge(crossing[0], crossing[1]), 0, 8}));
  // They touch in one of the two.
  const selvage_vertex touching[] = {
      {0, 128, 0, 0, 1}, {0, down, 0, 0, 1}, {0, 128, 0, 0, 1}, {9, down, 0, 0, 1}};
  const auto opening = from_left_to_right(between(touching, 8));
  ASSERT_TRUE(opening);
  EXPECT_EQ(&opening->a.top(), &touching[0]);
  const selvage_vertex closing[] = {
      {0, 0, 0, 0, 1}, {5, 7 * 256 + 128, 0, 0, 1}, {9, 0, 0, 0, 1}, {5, 7 * 256 + 128, 0, 0, 1}};
  const auto closed =
      from_left_to_right({Edge(closing[2], closing[3]), Edge(closing[0], closing[1]), 0, 8});
  ASSERT_TRUE(closed);
  EXPECT_EQ(&closed->a.top(), &closing[0]);
  EXPECT_TRUE(from_left_to_right(between(closing, 8)));
  EXPECT_TRUE(from_left_to_right(between(closing, 7)));
  // They do in all of them.
  const selvage_vertex one[] = {
      {5, 0, 0, 0, 1}, {5, down, 0, 0, 1}, {5, 0, 9, 0, 1}, {5, down, 9, 0, 1}};
  EXPECT_TRUE(from_left_to_right(between(one, 8)));
  EXPECT_TRUE(from_left_to_right(between(touching, 1)));
}

// Where all but one number of two ends are the same, they are two corners.
TEST(Slabs, HaveACornerForEachOfTheEndsThatDiffer) {
  const selvage_vertex end{0, 0, 5, 6, 7};
  const auto corners = [&](const selvage_vertex& other) {
    const selvage_vertex bottom{-900, 2000, 0, 0, 1}, other_bottom{900, 2000, 0, 0, 1};
    const Slab slab{Edge(end, bottom), Edge(other, other_bottom), 0, 8};
    return SlabOutline(slab).polygon().vertices.size();
  };
  EXPECT_EQ(corners(end), 3U);
  for (int32_t selvage_vertex::*number :
       {&selvage_vertex::x, &selvage_vertex::y, &selvage_vertex::u, &selvage_vertex::v,
        &selvage_vertex::q}) {
    selvage_vertex other = end;
    ++(other.*number);
    EXPECT_EQ(corners(other), 4U);
  }
  const selvage_vertex bottom{0, 2000, 0, 0, 1};
  const Slab one{Edge(end, bottom), Edge(end, bottom), 0, 8};
  EXPECT_TRUE(SlabOutline(one).polygon().vertices.empty());
}

TEST(Slabs, FewFitAMap) {
  const selvage_vertex v[] = {
      {0, 0, 0, 0, 1}, {0, 999, 0, 0, 1}, {9, 0, 0, 0, 1}, {9, 999, 0, 0, 1}};
  RuledMap map;
  for (size_t i = 0; i < RuledMap::kMostSlabs; ++i) EXPECT_TRUE(map.add(between(v, 1)));
  EXPECT_FALSE(map.add(between(v, 1)));
  EXPECT_EQ(map.slabs().size(), RuledMap::kMostSlabs);
}

}  // namespace
}  // namespace selvage::mapper
