#include "mapper/plane_frame.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "tests/vertex.h"

namespace selvage::mapper {
namespace {

// The area of a frame is positive however its vertices run, and may be the least there is.
TEST(PlaneFrame, IsOfThreeVerticesThatAreNotOnOneLine) {
  const std::vector<std::vector<selvage_vertex>> outlines = {
      {vertex(0, 0), vertex(1, 0), vertex(0, 1)},
      {vertex(0, 0), vertex(0, 1), vertex(1, 0)},
      {vertex(0, 0), vertex(256, 0), vertex(512, 0), vertex(0, 300)},
      {vertex(0, 0), vertex(512, 0), vertex(256, 0), vertex(0, 300)},
      {vertex(5, 5), vertex(5, 5), vertex(5, 5), vertex(6, 5), vertex(9, 9)},
      {vertex(5, 5), vertex(6, 5), vertex(5, 5), vertex(6, 5), vertex(7, 5), vertex(9, 9)},
      {vertex(-7, 3), vertex(-7, 3), vertex(100, 3), vertex(100, 3), vertex(-50, 3), vertex(8, 2)},
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
  EXPECT_EQ(PlaneFrame::of(std::vector{vertex(3, 4), vertex(3, 4), vertex(3, 4)}).doubled_area(),
            0);
  EXPECT_EQ(PlaneFrame::of(std::vector{vertex(0, 0), vertex(0, 0), vertex(1, 1)}).doubled_area(),
            0);
  EXPECT_EQ(PlaneFrame::of(std::vector{vertex(0, 0), vertex(7, 7), vertex(1, 1), vertex(-9, -9)})
                .doubled_area(),
            0);
}

[[nodiscard]] std::array<std::pair<int32_t, int32_t>, 3> places(const PlaneFrame& frame) {
  const selvage_vertex &a = frame.origin(), &b = frame.second(), &c = frame.third();
  return {std::pair(a.x, a.y), {b.x, b.y}, {c.x, c.y}};
}

// Of a parallelogram, two vertices are as far from the line through the other two.
TEST(PlaneFrame, IsTheSameWhateverTheOrderOfVertices) {
  std::vector<std::vector<selvage_vertex>> outlines = {
      {vertex(0, 0), vertex(1, 0), vertex(0, 1)},
      {vertex(0, 0), vertex(256, 0), vertex(256, 256), vertex(0, 256)},
      {vertex(0, 0), vertex(300, 100), vertex(400, 500), vertex(100, 400)},
      {vertex(0, 0), vertex(300, 100), vertex(400, 500), vertex(400, 500), vertex(100, 400)},
      {vertex(9, 9), vertex(-50, 300), vertex(8, 2), vertex(600, -7), vertex(44, 44)},
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
  for (const selvage_vertex third :
       {vertex(0, 1), vertex(1, 1), vertex(-1, -1), vertex(0, -1), vertex(2, 1)}) {
    EXPECT_EQ(PlaneFrame::canonical(std::vector{vertex(0, 0), vertex(1, 0), third}).doubled_area(),
              1)
        << third.x << ", " << third.y;
  }
  const auto line = std::vector{vertex(0, 0), vertex(7, 7), vertex(1, 1), vertex(-9, -9)};
  EXPECT_EQ(PlaneFrame::canonical(line).doubled_area(), 0);
  EXPECT_EQ(
      PlaneFrame::canonical(std::vector{vertex(3, 4), vertex(3, 4), vertex(3, 4)}).doubled_area(),
      0);
}

}  // namespace
}  // namespace selvage::mapper
