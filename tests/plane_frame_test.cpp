#include "mapper/plane_frame.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>
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

[[nodiscard]] std::array<std::pair<int32_t, int32_t>, 3> places(const PlaneFrame& frame) {
  const selvage_vertex &a = frame.origin(), &b = frame.second(), &c = frame.third();
  return {std::pair(a.x, a.y), {b.x, b.y}, {c.x, c.y}};
}

// Of a parallelogram, two vertices are as far from the line through the other two.
TEST(PlaneFrame, IsTheSameWhateverTheOrderOfVertices) {
  std::vector<std::vector<selvage_vertex>> outlines = {
      {at(0, 0), at(1, 0), at(0, 1)},
      {at(0, 0), at(256, 0), at(256, 256), at(0, 256)},
      {at(0, 0), at(300, 100), at(400, 500), at(100, 400)},
      {at(0, 0), at(300, 100), at(400, 500), at(400, 500), at(100, 400)},
      {at(9, 9), at(-50, 300), at(8, 2), at(600, -7), at(44, 44)},
  };
  for (std::vector<selvage_vertex>& outline : outlines) {
    const auto found = [&] {
      const PlaneFrame frame = PlaneFrame::canonical(outline);
      EXPECT_GT(frame.doubled_area(), 0);
      return places(frame);
    };
    const auto wanted = found();
    for (size_t i = 0; i < outline.size(); ++i) {
      std::ranges::rotate(outline, outline.begin() + 1);
      EXPECT_EQ(found(), wanted);
      std::ranges::reverse(outline);
      EXPECT_EQ(found(), wanted);
    }
  }
}

TEST(PlaneFrame, IsOfTheLeastAreasThatThereAre) {
  for (const selvage_vertex third : {at(0, 1), at(1, 1), at(-1, -1), at(0, -1), at(2, 1)}) {
    EXPECT_EQ(PlaneFrame::canonical(std::vector{at(0, 0), at(1, 0), third}).doubled_area(), 1)
        << third.x << ", " << third.y;
  }
  const auto line = std::vector{at(0, 0), at(7, 7), at(1, 1), at(-9, -9)};
  EXPECT_EQ(PlaneFrame::canonical(line).doubled_area(), 0);
  EXPECT_EQ(PlaneFrame::canonical(std::vector{at(3, 4), at(3, 4), at(3, 4)}).doubled_area(), 0);
}

}  // namespace
}  // namespace selvage::mapper
