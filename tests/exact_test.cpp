#include "spec/exact.h"

#include <gtest/gtest.h>

#include <vector>

#include "corner.h"

namespace selvage::spec {
namespace {

TEST(Exact, TriangleByHand) {
  // u = 2 x, v = 3 y.
  const std::vector triangle = {corner(0, 0, 0, 0), corner(4, 0, 8, 0), corner(0, 4, 0, 12)};
  const auto point = sample(triangle, 1, 1);
  ASSERT_TRUE(point);
  EXPECT_EQ(point->u, Rational(3));
  EXPECT_EQ(point->v, Rational(9, 2));
  // (2.5, 1.5) lies on the right edge and so outside; (1.5, 1.5) inside.
  EXPECT_FALSE(sample(triangle, 2, 1));
  EXPECT_FALSE(sample(triangle, -1, 1));
  EXPECT_FALSE(sample(triangle, 0, 4));
}

TEST(Exact, PerspectiveByHand) {
  // Half way along a row between q = 1 and q = 3 the far side weighs 1 to 3: u = 8 * 3 / 4.
  const std::vector square = {corner(0, 0, 0, 0, 1), corner(1, 0, 8, 0, 3), corner(1, 1, 8, 8, 3),
                              corner(0, 1, 0, 8, 1)};
  const auto point = sample(square, 0, 0);
  ASSERT_TRUE(point);
  EXPECT_EQ(point->u, Rational(6));
  EXPECT_EQ(point->v, Rational(4));
}

TEST(Exact, HalfOpenOnBothAxes) {
  // Sides through sample points: [1/2, 5/2) in x and y.
  std::vector<selvage_vertex> square = {
      {128, 128, 0, 0, 1}, {640, 128, 0, 0, 1}, {640, 640, 0, 0, 1}, {128, 640, 0, 0, 1}};
  for (int32_t y = -1; y < 4; ++y) {
    for (int32_t x = -1; x < 4; ++x) {
      EXPECT_EQ(sample(square, x, y).has_value(), 0 <= x && x < 2 && 0 <= y && y < 2);
    }
  }
}

TEST(Exact, CrossingChainsAreSortedRowByRow) {
  // An hourglass: the two sides change places half way down.
  const std::vector hourglass = {corner(0, 0, 0, 0), corner(4, 0, 4, 0), corner(0, 4, 0, 4),
                                 corner(4, 4, 4, 4)};
  ASSERT_EQ(validity(hourglass), SELVAGE_OK);
  for (int32_t y = 0; y < 4; ++y) {
    const auto line = scan_line(hourglass, y);
    ASSERT_TRUE(line);
    EXPECT_LE(line->left.x, line->right.x);
    EXPECT_TRUE(sample(hourglass, 1, 0) && sample(hourglass, 1, 3));
  }
}

TEST(Exact, ValidityCountsCrossings) {
  EXPECT_EQ(validity(std::vector{corner(0, 0, 0, 0), corner(4, 0, 0, 0)}),
            SELVAGE_ERROR_VERTEX_COUNT);
  EXPECT_EQ(validity(std::vector{corner(0, 0, 0, 0), corner(4, 0, 0, 0), corner(8, 0, 0, 0)}),
            SELVAGE_OK);
  EXPECT_EQ(validity(std::vector{corner(0, 0, 0, 0), corner(2, 4, 0, 0), corner(4, 1, 0, 0),
                                 corner(6, 4, 0, 0)}),
            SELVAGE_ERROR_NOT_MONOTONE);
}

TEST(Exact, FloorAndAddress) {
  EXPECT_EQ(floor(Rational(-1, 3)), -1);
  EXPECT_EQ(floor(Rational(7, 3)), 2);
  EXPECT_EQ(floor(Rational(-2)), -2);
  EXPECT_EQ(address_texel(-1, 5, SELVAGE_ADDRESS_CLAMP), 0);
  EXPECT_EQ(address_texel(5, 5, SELVAGE_ADDRESS_CLAMP), 4);
  EXPECT_EQ(address_texel(-1, 5, SELVAGE_ADDRESS_WRAP), 4);
  EXPECT_EQ(address_texel(-32768, 3, SELVAGE_ADDRESS_WRAP), 1);
  EXPECT_EQ(address_texel(12, 5, SELVAGE_ADDRESS_WRAP), 2);
}

}  // namespace
}  // namespace selvage::spec
