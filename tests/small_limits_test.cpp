// Which polygons are small: by limits of 16 px, 8 x 4 texels and depths of 1 to 3, from a texture
// of 20 x 10.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "mapper/polygon.h"
#include "mapper/small_polygons.h"
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
    return SmallPolygons::take(polygon, SmallEnds(texture, address), kLimits);
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

// Turned, all of it but the last vertex far from where the texture ends.
class SmallParallelograms : public SmallLimitsTo {
 protected:
  static inline const spec::Vertices kTurned{{0, 1000, 12 << 16, 8 << 16, 1},
                                             {1000, 0, 14 << 16, 7 << 16, 1},
                                             {4000, 3000, 19 << 16, 9 << 16, 1},
                                             {3000, 4000, 17 << 16, 10 << 16, 1}};
};

TEST_F(SmallParallelograms, AreTaken) {
  spec::Vertices quad = kTurned;
  EXPECT_FALSE(takes(quad));  // its last vertex is where the texture ends
  EXPECT_TRUE(takes(quad, SELVAGE_ADDRESS_CLAMP));
  for (selvage_vertex& vertex : quad) vertex.q = 7;
  EXPECT_TRUE(takes(quad, SELVAGE_ADDRESS_CLAMP));
  std::rotate(quad.begin(), quad.begin() + 1, quad.end());
  EXPECT_TRUE(takes(quad, SELVAGE_ADDRESS_CLAMP));
  std::reverse(quad.begin(), quad.end());
  EXPECT_TRUE(takes(quad, SELVAGE_ADDRESS_CLAMP));
}

TEST_F(SmallParallelograms, CloseInTheTargetAndInTheTexture) {
  for (const size_t vertex : {size_t{0}, size_t{1}, size_t{2}, size_t{3}}) {
    for (const auto of : {&selvage_vertex::x, &selvage_vertex::y, &selvage_vertex::u,
                          &selvage_vertex::v, &selvage_vertex::q}) {
      for (const int32_t by : {1, -1}) {
        spec::Vertices quad = kTurned;
        for (selvage_vertex& each : quad) each.q = 2;
        quad[vertex].*of += by;
        EXPECT_FALSE(takes(quad, SELVAGE_ADDRESS_CLAMP)) << vertex << " by " << by;
      }
    }
  }
}

// What shows the texture as it is is copied.
TEST_F(SmallParallelograms, AreTransformed) {
  spec::Vertices quad{{0, 0, 0, 0, 1},
                      {1024, 0, 4 << 16, 0, 1},
                      {1024, 512, 4 << 16, 2 << 16, 1},
                      {0, 512, 0, 2 << 16, 1}};
  EXPECT_FALSE(takes(quad));
  for (selvage_vertex& vertex : quad) vertex.x += 1;
  EXPECT_TRUE(takes(quad));
}

// One call draws those in perspective, or those that have four vertices, or neither.
TEST_F(SmallLimitsTo, HasRoomForKindsThatGoTogether) {
  spec::Vertices deep = kLargest, quad = kLargest;
  deep[0].q = 2;
  quad.push_back(kLargest[0]);
  Polygon plain_polygon, deep_polygon, quad_polygon;
  ASSERT_EQ(examine(kLargest, &plain_polygon), SELVAGE_OK);
  ASSERT_EQ(examine(deep, &deep_polygon), SELVAGE_OK);
  ASSERT_EQ(examine(quad, &quad_polygon), SELVAGE_OK);
  SmallPolygons small;
  const auto has_room = [&](bool for_plain, bool for_deep, bool for_quad) {
    EXPECT_EQ(small.has_room_for(plain_polygon), for_plain);
    EXPECT_EQ(small.has_room_for(deep_polygon), for_deep);
    EXPECT_EQ(small.has_room_for(quad_polygon), for_quad);
  };
  has_room(true, true, true);
  small.add(plain_polygon, {0, 0, 1, 1});
  has_room(true, true, true);
  small.add(quad_polygon, {0, 0, 1, 1});
  EXPECT_TRUE(small.have_four());
  has_room(true, false, true);
  small.clear();
  EXPECT_FALSE(small.have_four());
  for (size_t i = 0; i < SmallPolygons::kMost; ++i) {
    small.add(i == 0 ? deep_polygon : plain_polygon, {0, 0, 1, 1});
    EXPECT_FALSE(small.affine());
    if (i + 1 < SmallPolygons::kMost) has_room(true, true, false);
  }
  has_room(false, false, false);
}

TEST_F(SmallLimitsTo, IsFromTexturesOfRows) {
  selvage_texture texture{nullptr, 8, 8, 8, SELVAGE_INDEX8, SELVAGE_LAYOUT_ROWS, nullptr};
  EXPECT_TRUE(SmallPolygons::take_from(texture, kLimits));
  EXPECT_FALSE(SmallPolygons::take_from(texture, SmallLimits{}));
  texture.layout = SELVAGE_LAYOUT_TILES;
  EXPECT_FALSE(SmallPolygons::take_from(texture, kLimits));
}

}  // namespace
}  // namespace selvage::mapper
