// A slab's exact rows by differences are those that its edges make row by row.
#include "mapper/exact_slab.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "mapper/span_walk.h"
#include "spec/random.h"
#include "tests/slab_support.h"
#include "tests/span_support.h"

namespace selvage::mapper {
namespace {

[[nodiscard]] bool are_equal(const ExactLine& a, const ExactLine& b) {
  return a.start == b.start && a.step == b.step;
}
[[nodiscard]] bool are_equal(const ExactRow& a, const ExactRow& b) {
  return are_equal(a.u, b.u) && are_equal(a.v, b.v) && are_equal(a.d, b.d);
}

// Rows of a walk down some of a slab, in any order, each from one of its pixels: whichever edge is
// on the left, from whatever column the differences are.
void expect_rows_of(const Polygon& polygon, const Slab& slab, spec::Random& random, int* rows) {
  SpanWalk walk(polygon,
                {-40000, slab.first_row, 40000, std::min(slab.end_row, slab.first_row + 200)});
  std::vector<Span> spans;
  while (walk.next()) spans.push_back(walk.span());
  if (spans.empty()) return;
  if (random.percent(30)) std::ranges::reverse(spans);
  const RuledMap map(slab);
  const Span& from = spans[static_cast<size_t>(random.in(0, static_cast<int32_t>(spans.size())))];
  ExactSlab found(slab, random.in(from.left_px, from.right_px));
  for (const Span& span : spans) {
    if (random.percent(50)) continue;
    const int32_t px = random.in(span.left_px, span.right_px);
    ASSERT_TRUE(found.has(span.row));
    ASSERT_TRUE(are_equal(found.row_from(px, span.row), ExactMap(map).row_from(px, span.row)))
        << "pixel " << px << ", " << span.row;
    ++*rows;
  }
}

TEST(ExactSlab, AreThoseOfTheMap) {
  int rows = 0;
  spec::Random random(1);
  for (const bool affine : {true, false}) {
    for_each_slab(1500, affine, [&](const auto&, const Polygon& polygon, const Slab& slab) {
      expect_rows_of(polygon, slab, random, &rows);
    });
  }
  EXPECT_GT(rows, 50000);
}

// Edges that change sides between rows, and the largest numbers that there are.
TEST(ExactSlab, AreThoseOfTheMapBetweenEdgesThatCross) {
  constexpr int32_t kLeast_fx8 = SELVAGE_X_MIN, kMost_fx8 = SELVAGE_X_END - 1;
  const std::vector<selvage_vertex> vertices = {
      {kLeast_fx8, kLeast_fx8, INT32_MIN, INT32_MAX, SELVAGE_Q_MAX},
      {kMost_fx8, kMost_fx8, INT32_MAX, INT32_MIN, 1},
      {kLeast_fx8, kMost_fx8, INT32_MIN, INT32_MIN, SELVAGE_Q_MAX},
      {kMost_fx8, kLeast_fx8, INT32_MAX, INT32_MAX, SELVAGE_Q_MAX - 1}};
  const Edge down(vertices[0], vertices[1]), up(vertices[2], vertices[3]);
  const Slab slab{down, up, kLeast_fx8 / kSubpixels, kMost_fx8 / kSubpixels};
  const RuledMap map(slab);
  int before = 0, behind = 0;
  for (const int32_t first_px : {-32768, -1, 32767}) {
    ExactSlab found(slab, first_px);
    for (int32_t row = slab.first_row; row < slab.end_row; row += 97) {
      const int32_t px = row / 3;
      ASSERT_TRUE(are_equal(found.row_from(px, row), ExactMap(map).row_from(px, row))) << row;
      ++(row < 0 ? before : behind);
    }
  }
  EXPECT_GT(std::min(before, behind), 500);
}

// Rows of some quads, in any order and from any of their pixels.
TEST(ShortRuledRows, AreTheLowBitsOfTheMaps) {
  int rows = 0, not_served = 0;
  for (uint64_t seed = 1; seed <= 1500; ++seed) {
    spec::Random random(seed);
    const std::vector<selvage_vertex> vertices = any_quad(random, random.percent(70));
    Polygon polygon;
    if (examine(vertices, &polygon) != SELVAGE_OK) continue;
    const selvage_rect part = part_of(polygon, kEverywhere);
    RuledMap map;
    SlabWalk slabs(polygon, part);
    while (const auto slab = slabs.next()) ASSERT_TRUE(map.add(*slab));
    if (!is_directed(map)) {
      ++not_served;
      continue;
    }
    ShortRuledRowFinder found(map);
    SpanWalk walk(polygon, {-40000, part.top, 40000, std::min(part.bottom, part.top + 200)});
    std::vector<Span> spans;
    while (walk.next()) spans.push_back(walk.span());
    if (random.percent(30)) std::ranges::reverse(spans);
    for (const Span& span : spans) {
      if (random.percent(30)) continue;
      const int32_t px = random.in(span.left_px, span.right_px);
      const ExactRow row = found.row_from(px, span.row),
                     whole = ExactMap(map).row_from(px, span.row);
      for (ExactLine ExactRow::*const of : {&ExactRow::u, &ExactRow::v, &ExactRow::d}) {
        ASSERT_EQ(static_cast<uint64_t>((row.*of).start), static_cast<uint64_t>((whole.*of).start))
            << "seed " << seed << ", pixel " << px << ", " << span.row;
        ASSERT_EQ(static_cast<uint64_t>((row.*of).step), static_cast<uint64_t>((whole.*of).step));
      }
      ++rows;
    }
  }
  EXPECT_GT(rows, 50000);
  EXPECT_LT(not_served, 500);
}

// Edges that change sides between rows have no one sign.
TEST(ShortRuledRows, AreNotOfEdgesThatCross) {
  const std::vector<selvage_vertex> v = {
      {0, 0, 0, 0, 1}, {25600, 25600, 9, 9, 1}, {25600, 0, 9, 0, 1}, {0, 25600, 0, 9, 1}};
  const Edge down(v[0], v[1]), up(v[2], v[3]), side(v[0], v[3]);
  EXPECT_FALSE(is_directed(RuledMap(Slab{down, up, 0, 100})));
  EXPECT_TRUE(is_directed(RuledMap(Slab{up, down, 0, 50})));
  EXPECT_TRUE(is_directed(RuledMap(Slab{side, down, 1, 100})));
}

// One q cancels, so that numbers are no longer than those of q = 1; several do not.
TEST(ExactSlab, AreThoseOfOneWhereAllEndsHaveOneQ) {
  const auto row_of = [](int32_t q, int32_t last_q) {
    const selvage_vertex v[] = {
        {0, 0, 5, 6, q}, {100, 50000, 7, -9, q}, {900, 0, 9, 0, q}, {950, 50000, 99, 3, last_q}};
    const RuledMap map(Slab{Edge(v[0], v[1]), Edge(v[2], v[3]), 0, 100});
    const ExactRow row = RuledRowFinder(map).row_from(2, 30);
    EXPECT_TRUE(are_equal(row, ExactMap(map).row_from(2, 30)));
    return row;
  };
  const ExactRow one = row_of(1, 1);
  EXPECT_TRUE(are_equal(row_of(SELVAGE_Q_MAX, SELVAGE_Q_MAX), one));
  EXPECT_FALSE(are_equal(row_of(SELVAGE_Q_MAX, SELVAGE_Q_MAX - 1), one));
}

TEST(ExactSlab, AreOfTheSlabsRowsAlone) {
  const selvage_vertex v[] = {
      {0, 0, 0, 0, 1}, {0, 50000, 0, 0, 1}, {900, 0, 9, 0, 1}, {900, 50000, 99, 0, 1}};
  const ExactSlab rows(Slab{Edge(v[0], v[1]), Edge(v[2], v[3]), 10, 13}, 1);
  for (const int32_t row : {10, 11, 12}) EXPECT_TRUE(rows.has(row));
  for (const int32_t row : {9, 13, INT32_MIN, INT32_MAX}) EXPECT_FALSE(rows.has(row));
  for (const int32_t row : {INT32_MIN, -1, 0, 1}) EXPECT_FALSE(ExactSlab().has(row));
}

}  // namespace
}  // namespace selvage::mapper
