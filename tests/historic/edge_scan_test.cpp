#include "historic/edge_scan.h"

#include <gtest/gtest.h>

#include <array>
#include <vector>

namespace selvage::historic {
namespace {

[[nodiscard]] selvage_vertex at_px(int32_t x_px, int32_t y_px, int32_t u = 0, int32_t v = 0) {
  return {x_px * SELVAGE_SUBPIXELS, y_px * SELVAGE_SUBPIXELS, u, v, 1};
}

// A triangle whose left edge runs from (0, 0) to (width, height).
[[nodiscard]] std::array<selvage_vertex, 3> with_edge(int32_t width_px, int32_t height_px,
                                                      int32_t u_end = 0) {
  return {at_px(0, 0), at_px(2000, 0), at_px(width_px, height_px, u_end, -u_end)};
}

[[nodiscard]] mapper::Polygon examined(std::span<const selvage_vertex> vertices) {
  mapper::Polygon polygon;
  EXPECT_EQ(mapper::examine(vertices, &polygon), SELVAGE_OK);
  return polygon;
}

[[nodiscard]] int32_t ceiling(int64_t a, int64_t b) {
  return static_cast<int32_t>(a >= 0 ? (a + b - 1) / b : -(-a / b));
}

// The error term's start decides this: 0 where x grows, 1 - height where it falls.
TEST(EdgeScan, ColumnIsTheCeilingOfX) {
  for (int32_t height = 1; height <= 48; ++height) {
    for (int32_t width = -100; width <= 100; ++width) {
      const auto vertices = with_edge(width, height);
      const mapper::Polygon polygon = examined(vertices);
      EdgeScan edge(polygon, EdgeScan::Direction::kLeft, Prestep::kNone);
      for (int32_t row = 0; row < height; ++row) {
        edge.go_to(row);
        ASSERT_EQ(edge.column_px(), ceiling(int64_t{width} * row, height))
            << width << " / " << height << ", row " << row;
      }
    }
  }
}

TEST(EdgeScan, JumpsToWhereItWouldHaveStepped) {
  for (const int32_t width : {-997, -64, -1, 0, 1, 63, 64, 65, 1999}) {
    for (const int32_t height : {1, 2, 3, 64, 65, 1000}) {
      for (const Prestep prestep : {Prestep::kNone, Prestep::kHalf}) {
        const auto vertices = with_edge(width, height, 1234567);
        const mapper::Polygon polygon = examined(vertices);
        EdgeScan stepped(polygon, EdgeScan::Direction::kLeft, prestep);
        for (int32_t row = 0; row < height; ++row) {
          stepped.go_to(row);
          EdgeScan jumped(polygon, EdgeScan::Direction::kLeft, prestep);
          jumped.go_to(row);
          ASSERT_EQ(jumped.column_px(), stepped.column_px());
          ASSERT_EQ(jumped.u_fx16(), stepped.u_fx16());
          ASSERT_EQ(jumped.v_fx16(), stepped.v_fx16());
        }
      }
    }
  }
}

TEST(EdgeScan, SourceStepsTowardZero) {
  const auto vertices = with_edge(0, 3, 100);  // steps of 33, and of -33 rather than -34
  const mapper::Polygon polygon = examined(vertices);
  EdgeScan edge(polygon, EdgeScan::Direction::kLeft, Prestep::kNone);
  for (int32_t row = 0; row < 3; ++row) {
    edge.go_to(row);
    EXPECT_EQ(edge.u_fx16(), 33 * row);
    EXPECT_EQ(edge.v_fx16(), -33 * row);
  }
}

TEST(EdgeScan, PrestepTakesHalfAStepDownward) {
  const auto vertices = with_edge(0, 3, 100);
  const mapper::Polygon polygon = examined(vertices);
  EdgeScan edge(polygon, EdgeScan::Direction::kLeft, Prestep::kHalf);
  edge.go_to(2);
  EXPECT_EQ(edge.u_fx16(), 16 + 66);
  EXPECT_EQ(edge.v_fx16(), -17 - 66);
}

// Truncated steps end short of the far vertex; rounded ones could pass it.
TEST(EdgeScan, SourceNeverPassesTheEnd) {
  bool rounded_would = false;
  for (int32_t height = 1; height <= 300; ++height) {
    for (const int32_t end : {1, 2, 99, 100, 101, 65535, 65536, 1000003}) {
      const SourceWalk up(0, end, height, Prestep::kNone), down(0, -end, height, Prestep::kHalf);
      ASSERT_LE(up.at_fx16 + up.step_fx16 * height, end);
      ASSERT_GE(down.at_fx16 + down.step_fx16 * (height - 1), -end);
      const int64_t rounded = (2 * int64_t{end} + height) / (2 * height);
      rounded_would = rounded_would || rounded * height > end;
    }
  }
  EXPECT_TRUE(rounded_would);
}

TEST(EdgeScan, GoesOnWithTheNextEdgeAndPassesHorizontalOnesBy) {
  // The right chain: horizontal, down, horizontal, down.
  const std::vector<selvage_vertex> vertices = {at_px(0, 0),  at_px(10, 0, 65536),
                                                at_px(12, 2), at_px(20, 2, 7 * 65536),
                                                at_px(16, 6), at_px(0, 6)};
  const mapper::Polygon polygon = examined(vertices);
  EdgeScan right(polygon, EdgeScan::Direction::kRight, Prestep::kNone);
  const std::array<int32_t, 6> columns = {10, 11, 20, 19, 18, 17};
  for (int32_t row = 0; row < 6; ++row) {
    right.go_to(row);
    EXPECT_EQ(right.column_px(), columns[static_cast<size_t>(row)]) << row;
  }
  EdgeScan jumped(polygon, EdgeScan::Direction::kRight, Prestep::kNone);
  jumped.go_to(2);
  EXPECT_EQ(jumped.u_fx16(), 7 * 65536);
}

TEST(EdgeScan, HoldsTheEndsOfEveryRange) {
  const std::vector<selvage_vertex> vertices = {
      {SELVAGE_X_MIN, SELVAGE_X_MIN, INT32_MIN, INT32_MAX, 1},
      {SELVAGE_X_END - 256, SELVAGE_X_MIN, INT32_MAX, INT32_MIN, 1},
      {SELVAGE_X_END - 256, SELVAGE_X_END - 256, INT32_MAX, INT32_MIN, 1}};
  const mapper::Polygon polygon = examined(vertices);
  EdgeScan left(polygon, EdgeScan::Direction::kLeft, Prestep::kHalf);
  left.go_to(32766);
  EXPECT_EQ(left.column_px(), 32766);
  EXPECT_LE(left.u_fx16(), INT32_MAX);
  EXPECT_GE(left.v_fx16(), INT32_MIN);
  EXPECT_GT(left.u_fx16(), INT32_MAX - 2 * 65536);
}

}  // namespace
}  // namespace selvage::historic
