#include "mapper/filter_point.h"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

#include "spec/exact.h"
#include "spec/random.h"
#include "tests/span_support.h"

namespace selvage::mapper {
namespace {

[[nodiscard]] int32_t point_fx8(const spec::Rational& coordinate) {
  return spec::floor(256 * (coordinate - spec::Rational(1, 2)));
}

template <class Lanes>
void expect_exact_points(std::span<const selvage_vertex> vertices, const SpanMap& map,
                         const Span& span, const Lanes& lanes) {
  for (int32_t px = span.left_px; px < span.right_px; ++px) {
    const auto exact = spec::sample(vertices, px, span.row);
    ASSERT_TRUE(exact);
    const FilterPoint point = filter_point(ExactMap(map), span, lanes, px);
    ASSERT_EQ(point.u_fx8, point_fx8(exact->u)) << "pixel " << px;
    ASSERT_EQ(point.v_fx8, point_fx8(exact->v)) << "pixel " << px;
  }
}

void expect_exact_points_of_generated_spans(uint64_t cases) {
  for_each_generated_span(cases, [&](const spec::Case& c, const Polygon& polygon,
                                     const SpanMap& map, const Span& span) {
    if (testing::Test::HasFatalFailure()) return;
    if (polygon.affine) {
      expect_exact_points(c.vertices, map, span, AffineLanes(map, span).field(span));
    }
    expect_exact_points(c.vertices, map, span, ProjectiveLanes(map, span));
    ASSERT_FALSE(testing::Test::HasFatalFailure()) << spec::print(c);
  });
}

TEST(FilterPoint, IsTheFloorOnAGridOfATexelsFractions) {
  expect_exact_points_of_generated_spans(250);
}
TEST(FilterPointAtLength, IsTheFloorOnAGridOfATexelsFractions) {
  expect_exact_points_of_generated_spans(2500);
}

// With q in such a ratio lanes are low by more than a step of the grid.
void expect_exact_points_of_wide_ratios(int triangles) {
  spec::Random random(3);
  const auto texel = [&] { return random.pick({INT32_MIN, INT32_MAX, 0, 65536, -65537}); };
  for (int i = 0; i < triangles; ++i) {
    std::vector<selvage_vertex> vertices;
    for (const auto& [x, y] :
         {std::pair(0, 0), std::pair(40 * 256, 77), std::pair(300, 20 * 256)}) {
      const int32_t u = texel(), v = texel();
      vertices.push_back({x, y, u, v, vertices.size() == 1 ? SELVAGE_Q_MAX : 1});
    }
    Polygon polygon;
    ASSERT_EQ(examine(vertices, &polygon), SELVAGE_OK);
    for_each_row(polygon, 0, 20, 0, 64, [&](const Edge& left, const Edge& right, const Span& span) {
      const SpanMap map(left.at(span.row), right.at(span.row));
      expect_exact_points(vertices, map, span, ProjectiveLanes(map, span));
    });
    ASSERT_FALSE(testing::Test::HasFatalFailure());
  }
}

TEST(FilterPoint, IsExactWhereLanesTellNothing) { expect_exact_points_of_wide_ratios(30); }
TEST(FilterPointAtLength, IsExactWhereLanesTellNothing) { expect_exact_points_of_wide_ratios(300); }

// The least coordinate and the greatest, from one too low by a step and from their own.
TEST(FilterPoint, IsDecidedAtTheEndsOfTheRange) {
  constexpr int32_t most_fx8 = -kLeastPoint_fx8 - 1;
  for (const int128 d : {int128{1} << 16, int128{12345} << 16, int128{1} << 110}) {
    const int128 step = d >> kGridBits;
    for (const int32_t point_fx8 :
         {kLeastPoint_fx8, kLeastPoint_fx8 + 1, -1, 0, 1, most_fx8 - 1, most_fx8}) {
      const int128 least = step * point_fx8, last = least + step - 1;
      for (const int32_t low_by : {0, 1, 2, 3}) {
        ASSERT_EQ(decide_fx8(least, d, point_fx8 - low_by), point_fx8);
        ASSERT_EQ(decide_fx8(last, d, point_fx8 - low_by), point_fx8);
      }
    }
  }
}

}  // namespace
}  // namespace selvage::mapper
