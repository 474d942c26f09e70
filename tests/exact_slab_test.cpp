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
