#include "mapper/plane_frame.h"

#include <gtest/gtest.h>

#include <vector>

namespace selvage::mapper {
namespace {

[[nodiscard]] selvage_vertex at(int32_t x, int32_t y) { return {x, y, 0, 0, 1}; }

// The area of a frame is positive however its vertices run, and may be the least there is.
TEST(PlaneFrame, IsOfThreeVerticesThatAreNotOnOneLine) {
  const std::vector<std::vector<selvage_vertex>> outlines = {
      {at(0, 0), at(1, 0), at(0, 1)},
      {at(0, 0), at(0, 1), at(1, 0)},
      {at(0, 0), at(256, 0), at(512, 0), at(0, 300)},
      {at(0, 0), at(512, 0), at(256, 0), at(0, 300)},
      {at(5, 5), at(5, 5), at(5, 5), at(6, 5), at(9, 9)},
      {at(5, 5), at(6, 5), at(5, 5), at(6, 5), at(7, 5), at(9, 9)},
      {at(-7, 3), at(-7, 3), at(100, 3), at(100, 3), at(-50, 3), at(8, 2)},
  };
  for (const std::vector<selvage_vertex>& outline : outlines) {
    const auto frame = PlaneFrame::of(outline);
    const selvage_vertex &a = frame.origin(), &b = frame.second(), &c = frame.third();
    const int64_t area = int64_t{b.x - a.x} * (c.y - a.y) - int64_t{c.x - a.x} * (b.y - a.y);
    EXPECT_GT(area, 0);
    EXPECT_EQ(frame.doubled_area(), area);
    EXPECT_EQ(&a, outline.data());
  }
}

TEST(PlaneFrame, IsNotOfVerticesOnOneLine) {
  EXPECT_EQ(PlaneFrame::of(std::vector{at(3, 4), at(3, 4), at(3, 4)}).doubled_area(), 0);
  EXPECT_EQ(PlaneFrame::of(std::vector{at(0, 0), at(0, 0), at(1, 1)}).doubled_area(), 0);
  EXPECT_EQ(PlaneFrame::of(std::vector{at(0, 0), at(7, 7), at(1, 1), at(-9, -9)}).doubled_area(),
            0);
}

}  // namespace
}  // namespace selvage::mapper
