#include "mapper/box_side.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace selvage::mapper {
namespace {

TEST(BoxSide, HasTheTexelsThatItTouchesWhereItTouchesMost) {
  for (int32_t side_fx8 = 256; side_fx8 <= 1300; ++side_fx8) {
    int32_t most = 0;
    for (int32_t begin_fx8 = 512; begin_fx8 < 768; ++begin_fx8) {
      const int32_t last_fx8 = begin_fx8 + side_fx8 - 1;
      most = std::max(most, (last_fx8 >> 8) - (begin_fx8 >> 8) + 1);
      const BoxSide side = BoxSide::of(begin_fx8, side_fx8);
      ASSERT_EQ(side.first_texel, 2);
      ASSERT_EQ(side.part_fx8, begin_fx8 - 512);
      ASSERT_EQ(side.side_fx8, side_fx8);
    }
    ASSERT_EQ(BoxSide::of(0, side_fx8).texels, most) << side_fx8;
  }
  EXPECT_EQ(BoxSide::of(-1, 256).first_texel, -1);
  EXPECT_EQ(BoxSide::of(-1, 256).part_fx8, 255);
}

TEST(BoxSide, IsInsideFromTheFirstTexelToTheLast) {
  for (int32_t texels = 2; texels <= 9; ++texels) {
    for (int32_t first = -3; first <= 9; ++first) {
      const BoxSide side{first, texels, 0, 0};
      const bool below = first<0, beyond = first + texels - 1> 7;
      ASSERT_EQ(side.is_inside(8), !below && !beyond) << first << ", " << texels;
    }
  }
}

TEST(BoxSide, BeginsInTheFirstPeriod) {
  for (const int32_t size_texel : {1, 2, 3, 8}) {
    for (int32_t begin_fx8 = -5000; begin_fx8 <= 5000; ++begin_fx8) {
      int32_t wanted = begin_fx8;
      while (wanted < 0) wanted += size_texel * 256;
      while (wanted >= size_texel * 256) wanted -= size_texel * 256;
      ASSERT_EQ(in_first_period(begin_fx8, size_texel), wanted) << begin_fx8;
    }
  }
  EXPECT_EQ(in_first_period(INT32_MIN, 32767), (int64_t{INT32_MIN} % 8388352) + 8388352);
}

}  // namespace
}  // namespace selvage::mapper
