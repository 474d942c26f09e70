#include "spec/gradient.h"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

#include "corner.h"
#include "spec/generate.h"

namespace selvage::spec {
namespace {

TEST(Gradient, OfAnAffineTriangleIsItsPlanes) {
  // u = 3 x - y, v = x / 2 + 2 y.
  const selvage_vertex triangle[] = {corner(0, 0, 0, 0), corner(8, 0, 24, 4), corner(0, 8, -8, 16)};
  for (const auto& [x, y] : {std::pair(0, 0), std::pair(5, 1), std::pair(1, 5)}) {
    const auto g = gradient(triangle, x, y);
    ASSERT_TRUE(g);
    EXPECT_EQ(g->u_along_x, 3);
    EXPECT_EQ(g->u_along_y, -1);
    EXPECT_EQ(g->v_along_x, Rational(1, 2));
    EXPECT_EQ(g->v_along_y, 2);
  }
  EXPECT_FALSE(gradient(triangle, 7, 7));
  EXPECT_FALSE(gradient(triangle, 0, -1));
}

// On the line y = 1 - q of a floor: q = 1 + y / 8, u = x / q, v = 8 y / q.
TEST(Gradient, OfAFloorIsThatOfTheQuotient) {
  const selvage_vertex floor[] = {corner(0, 0, 0, 0, 1), corner(8, 0, 8, 0, 1),
                                  corner(8, 8, 4, 32, 2), corner(0, 8, 0, 32, 2)};
  const auto g = gradient(floor, 3, 2);
  ASSERT_TRUE(g);
  const Rational x(7, 2), y(5, 2), q = 1 + y / 8;
  EXPECT_EQ(g->u_along_x, 1 / q);
  EXPECT_EQ(g->u_along_y, -x / (8 * q * q));
  EXPECT_EQ(g->v_along_x, 0);
  EXPECT_EQ(g->v_along_y, 8 / (q * q));
}

// A trapezoid whose texture is a square: along a row u is divided by the row's width, which
// changes.
TEST(Gradient, OfARuledQuadrilateralFollowsBothEdges) {
  const selvage_vertex trapezoid[] = {corner(0, 0, 0, 0), corner(8, 0, 8, 0), corner(16, 8, 8, 8),
                                      corner(0, 8, 0, 8)};
  const auto g = gradient(trapezoid, 5, 3);
  ASSERT_TRUE(g);
  const Rational x(11, 2), y(7, 2), width = 8 + y;  // u = 8 x / (8 + y), v = y
  EXPECT_EQ(g->u_along_x, 8 / width);
  EXPECT_EQ(g->u_along_y, -8 * x / (width * width));
  EXPECT_EQ(g->v_along_x, 0);
  EXPECT_EQ(g->v_along_y, 1);
}

// Of any two polygons on one plane: so filtered meshes have no seams.
void expect_one_gradient(const std::vector<selvage_vertex>& quad) {
  for (size_t first = 0; first < 4; ++first) {
    const std::vector<selvage_vertex> half = {quad[first], quad[(first + 1) % 4],
                                              quad[(first + 2) % 4]};
    int compared = 0;
    for (int32_t y = 0; y < 20; ++y) {
      for (int32_t x = 0; x < 20; ++x) {
        const auto whole = gradient(quad, x, y), part = gradient(half, x, y);
        if (!whole || !part) continue;
        ++compared;
        ASSERT_EQ(whole->u_along_x, part->u_along_x);
        ASSERT_EQ(whole->u_along_y, part->u_along_y);
        ASSERT_EQ(whole->v_along_x, part->v_along_x);
        ASSERT_EQ(whole->v_along_y, part->v_along_y);
      }
    }
    EXPECT_GT(compared, 20);
  }
}

TEST(Gradient, IsOneForAllPolygonsOfAnAffinePlane) {
  const auto on_plane = [](int32_t x, int32_t y) {
    return selvage_vertex{x * 256 + 5, y * 256 + 9, x * 200000 + y * 70000, y * 90000 - x * 3000,
                          1};
  };
  expect_one_gradient({on_plane(0, 0), on_plane(20, 3), on_plane(17, 19), on_plane(2, 15)});
}

TEST(Gradient, IsOneForAllPolygonsOfAProjectivePlane) {
  expect_one_gradient({corner(0, 0, 0, 0, 1), corner(8, 0, 8, 0, 1), corner(8, 8, 4, 32, 2),
                       corner(0, 8, 0, 32, 2)});
}

// What the derivative along a row means: the slope of ever shorter chords, here of the map's own
// values a pixel apart, which for an affine span is the same.
void expect_differences_of_pixels(int seeds) {
  int compared = 0;
  for (uint64_t seed = 0; seed < static_cast<uint64_t>(seeds); ++seed) {
    Case c = generate(seed);
    for (selvage_vertex& v : c.vertices) v.q = 1;
    if (validity(c.vertices) != SELVAGE_OK) continue;
    for (int32_t y = 0; y < c.target_height_px; y += 2) {
      for (int32_t x = 0; x + 1 < c.target_width_px; x += 3) {
        const auto here = sample(c.vertices, x, y), next = sample(c.vertices, x + 1, y);
        const auto g = gradient(c.vertices, x, y);
        ASSERT_EQ(here.has_value(), g.has_value());
        if (!here || !next) continue;
        ASSERT_EQ(g->u_along_x, next->u - here->u);
        ASSERT_EQ(g->v_along_x, next->v - here->v);
        ++compared;
      }
    }
  }
  EXPECT_GT(compared, seeds * 2 / 3);
}

TEST(Gradient, AlongAnAffineRowIsTheDifferenceOfTwoPixels) { expect_differences_of_pixels(150); }
TEST(GradientAtLength, AlongAnAffineRowIsTheDifferenceOfTwoPixels) {
  expect_differences_of_pixels(1500);
}

}  // namespace
}  // namespace selvage::spec
