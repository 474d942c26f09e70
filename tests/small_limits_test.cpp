// Which triangles are small: by limits of 16 px, 8 x 4 texels and depths of 1 to 3, from a texture
// of 20 x 10.
#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>

#include "mapper/polygon.h"
#include "mapper/small_triangles.h"
#include "spec/case.h"

namespace selvage::mapper {
namespace {

class SmallLimitsTo : public testing::Test {
 protected:
  static constexpr SmallLimits kLimits{16, 8, 4, 3};

  [[nodiscard]] static bool takes(const spec::Vertices& triangle,
                                  selvage_address address = SELVAGE_ADDRESS_WRAP) {
    static constexpr uint8_t kTexels[200] = {};
    const selvage_texture texture{kTexels, 20, 10, 20, SELVAGE_INDEX8, SELVAGE_LAYOUT_ROWS,
                                  nullptr};
    Polygon polygon;
    EXPECT_EQ(examine(triangle, &polygon), SELVAGE_OK);
    return SmallTriangles::take(polygon, SmallEnds(texture, address), kLimits);
  }
  // All limits are met by less than a unit.
  static inline const spec::Vertices kLargest{{-127, -127, 12 << 16, 6 << 16, 1},
                                              {128 + 16 * 256, 300, (20 << 16) - 1, 6 << 16, 1},
                                              {400, 128 + 16 * 256, 13 << 16, (10 << 16) - 1, 1}};
};

TEST_F(SmallLimitsTo, IsWhatMeetsTheLimits) {
  EXPECT_TRUE(takes(kLargest));
  spec::Vertices other = kLargest;
  for (selvage_vertex& vertex : other) vertex.q = 5;
  EXPECT_TRUE(takes(other));
  for (const size_t vertex : {size_t{0}, size_t{1}, size_t{2}}) {
    other[vertex].q = 15;
    EXPECT_TRUE(takes(other)) << vertex;
    other[vertex].q = 16;
    EXPECT_FALSE(takes(other)) << vertex;
    other[vertex].q = 5;
  }
}

TEST_F(SmallLimitsTo, IsNotWhatExceedsOne) {
  const auto expect_left = [](size_t vertex, int32_t selvage_vertex::*of, int32_t by) {
    spec::Vertices other = kLargest;
    other[vertex].*of += by;
    EXPECT_FALSE(takes(other)) << "vertex " << vertex << " by " << by;
  };
  expect_left(0, &selvage_vertex::x, -1);
  expect_left(1, &selvage_vertex::x, 1);
  expect_left(0, &selvage_vertex::y, -1);
  expect_left(2, &selvage_vertex::y, 1);
  expect_left(0, &selvage_vertex::u, -1);
  expect_left(1, &selvage_vertex::u, 1);
  expect_left(0, &selvage_vertex::v, -1);
  expect_left(2, &selvage_vertex::v, 1);
  expect_left(1, &selvage_vertex::q, 3);
  spec::Vertices quad = kLargest;
  quad.push_back({kLargest[2].x - 1, kLargest[2].y, kLargest[2].u, kLargest[2].v, 1});
  EXPECT_FALSE(takes(quad));
}

TEST_F(SmallLimitsTo, LiesInTheTexture) {
  const auto moved = [](int32_t selvage_vertex::*of, int32_t by) {
    spec::Vertices triangle = kLargest;
    for (selvage_vertex& vertex : triangle) vertex.*of += by;
    return triangle;
  };
  EXPECT_TRUE(takes(moved(&selvage_vertex::u, -(12 << 16))));
  EXPECT_FALSE(takes(moved(&selvage_vertex::u, -(13 << 16))));
  EXPECT_FALSE(takes(moved(&selvage_vertex::u, 1 << 16)));
  EXPECT_TRUE(takes(moved(&selvage_vertex::v, -(6 << 16))));
  EXPECT_FALSE(takes(moved(&selvage_vertex::v, -(7 << 16))));
  EXPECT_FALSE(takes(moved(&selvage_vertex::v, 1 << 16)));
}

TEST_F(SmallLimitsTo, MayEndWithAClampedTexture) {
  spec::Vertices triangle = kLargest;
  triangle[0].u += 1 << 16;
  triangle[0].v += 1 << 16;
  triangle[1].v += 1 << 16;
  triangle[1].u = 20 << 16;
  triangle[2].v = 10 << 16;
  EXPECT_TRUE(takes(triangle, SELVAGE_ADDRESS_CLAMP));
  EXPECT_FALSE(takes(triangle, SELVAGE_ADDRESS_WRAP));
  for (selvage_vertex& vertex : triangle) ++vertex.u;
  EXPECT_FALSE(takes(triangle, SELVAGE_ADDRESS_CLAMP));
}

TEST_F(SmallLimitsTo, IsFromTexturesOfRows) {
  selvage_texture texture{nullptr, 8, 8, 8, SELVAGE_INDEX8, SELVAGE_LAYOUT_ROWS, nullptr};
  EXPECT_TRUE(SmallTriangles::take_from(texture, kLimits));
  EXPECT_FALSE(SmallTriangles::take_from(texture, SmallLimits{}));
  texture.layout = SELVAGE_LAYOUT_TILES;
  EXPECT_FALSE(SmallTriangles::take_from(texture, kLimits));
}

}  // namespace
}  // namespace selvage::mapper
