#include "spec/geometry.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "spec/exact.h"
#include "spec/generate.h"

namespace selvage::spec {
namespace {

[[nodiscard]] selvage_vertex at(int32_t x, int32_t y) { return {x, y, 0, 0, 1}; }

TEST(Geometry, HullKeepsCornersOnly) {
  const std::vector points = {at(0, 0), at(8, 0), at(4, 0), at(8, 8), at(0, 8), at(3, 3), at(0, 0)};
  const auto hull = convex_hull(points);
  ASSERT_EQ(hull.size(), 4U);
  for (size_t i = 0; i < 4; ++i) {
    EXPECT_GT(
        doubled_area(position(hull[i]), position(hull[(i + 1) % 4]), position(hull[(i + 2) % 4])),
        0);
  }
  EXPECT_LT(convex_hull(std::vector{at(0, 0), at(1, 1), at(2, 2)}).size(), 3U);
}

TEST(Geometry, SegmentsAreClosed) {
  EXPECT_TRUE(on_segment({0, 0}, {0, 0}, {4, 2}));
  EXPECT_TRUE(on_segment({2, 1}, {0, 0}, {4, 2}));
  EXPECT_FALSE(on_segment({6, 3}, {0, 0}, {4, 2}));
  EXPECT_FALSE(on_segment({2, 2}, {0, 0}, {4, 2}));
}

// On y-monotone outlines that do not cross themselves, winding is coverage.
TEST(Geometry, WindingIsCoverageOnConvexOutlines) {
  uint64_t inside = 0;
  for (uint64_t seed = 1; seed <= 400; ++seed) {
    const Case c = generate(seed);
    const auto hull = convex_hull(c.vertices);
    if (hull.size() < 3) continue;
    for (int32_t y = 0; y < std::min(c.target_height_px, 12); ++y) {
      for (int32_t x = 0; x < std::min(c.target_width_px, 12); ++x) {
        const bool covered = sample(hull, x, y).has_value();
        ASSERT_EQ(winding_number(pixel_centre(x, y), hull), covered ? 1 : 0) << print(c);
        inside += covered ? 1 : 0;
      }
    }
  }
  EXPECT_GT(inside, 1000U);
}

}  // namespace
}  // namespace selvage::spec
