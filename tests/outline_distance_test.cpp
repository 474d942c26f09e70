#include "spec/outline_distance.h"

#include <gtest/gtest.h>

#include <vector>

#include "spec/generate_historic.h"
#include "spec/law_tools.h"

namespace selvage::spec {
namespace {

using Outline = std::vector<selvage_vertex>;

[[nodiscard]] Outline triangle(Point a, Point b, Point c) {
  return {vertex_at(a, {}), vertex_at(b, {}), vertex_at(c, {})};
}

TEST(OutlineDistance, IsTheGreaterOfBothDirections) {
  const Outline right_angle = triangle({0, 0}, {2560, 0}, {0, 2560});
  EXPECT_EQ(outline_distance_px({0, 0}, right_angle), 0) << "a corner";
  EXPECT_EQ(outline_distance_px({1280, 0}, right_angle), 0) << "an edge";
  EXPECT_EQ(outline_distance_px({1280, -256}, right_angle), 1) << "straight above one";
  EXPECT_EQ(outline_distance_px({-256, -128}, right_angle), 1) << "beyond a corner";
  EXPECT_EQ(outline_distance_px({256, 512}, right_angle), 1) << "the left edge is nearest";
  EXPECT_EQ(outline_distance_px({1280, 1281}, right_angle), Rational(1, 512)) << "a slope";
  EXPECT_EQ(outline_distance_px({1536, 1536}, right_angle), 1);
}

TEST(OutlineDistance, OfOutlinesWithoutAreaIsThatOfWhatIsThere) {
  EXPECT_EQ(outline_distance_px({256, 768}, triangle({0, 0}, {0, 0}, {0, 0})), 3);
  EXPECT_EQ(outline_distance_px({0, 512}, triangle({-256, 0}, {256, 0}, {0, 0})), 2);
}

// In numbers as large as there are.
TEST(OutlineDistance, OfFarVerticesIsExact) {
  const int64_t first = SELVAGE_X_MIN, last = SELVAGE_X_END - 1;
  const Outline thin = triangle({first, first}, {last, last}, {last, last - 1});
  EXPECT_EQ(outline_distance_px({0, 1}, thin), Rational(1, 512));
  EXPECT_TRUE(is_near_outline({0, 1}, thin, 128));
  EXPECT_FALSE(is_near_outline({0, 1}, thin, 127));
  EXPECT_FALSE(is_near_outline({first, last}, thin, SELVAGE_SUBTEXELS));
}

// The two answers are made in different ways.
TEST(OutlineDistance, IsAtMostWhatIsNear) {
  int near = 0;
  for (uint64_t seed = 0; seed < 400; ++seed) {
    const Case c = generate(seed, SELVAGE_PROFILE_EXACT);
    if (c.vertices.empty()) continue;
    Choices choices(c.choice);
    for (int i = 0; i < 20; ++i) {
      const Point p = sample_point(c, choose_pixel(c, choices));
      const Rational px = outline_distance_px(p, c.vertices);
      EXPECT_NEAR(about_outline_distance_px(p, c.vertices), px.get_d(),
                  px.get_d() * 1e-14 + 0x1p-35);
      const Rational fx16 = px * SELVAGE_SUBTEXELS;
      for (const int32_t reach_fx16 : {0, 1, 255, 256, 4096, 65535, 65536}) {
        EXPECT_EQ(is_near_outline(p, c.vertices, reach_fx16), fx16 <= reach_fx16)
            << print(c) << p.x << ' ' << p.y << ' ' << reach_fx16;
      }
      if (fx16 <= SELVAGE_SUBTEXELS) {
        const int32_t whole_fx16 = floor(fx16);
        EXPECT_EQ(is_near_outline(p, c.vertices, whole_fx16), fx16 == whole_fx16);
        EXPECT_TRUE(whole_fx16 == SELVAGE_SUBTEXELS ||
                    is_near_outline(p, c.vertices, whole_fx16 + 1));
        ++near;
      }
    }
  }
  EXPECT_GT(near, 500);
}

}  // namespace
}  // namespace selvage::spec
