#include "mapper/number.h"

#include <gtest/gtest.h>

#include <cmath>

namespace selvage::mapper {
namespace {

TEST(Number, FloorDivRoundsDown) {
  for (int64_t a = -20; a <= 20; ++a) {
    for (int64_t b = 1; b <= 7; ++b) {
      EXPECT_EQ(floor_div(a, b),
                std::llround(std::floor(static_cast<double>(a) / static_cast<double>(b))));
    }
  }
}

TEST(Number, FirstCentreIsAtOrBelow) {
  for (int32_t y = -1025; y <= 1025; ++y) {
    const int32_t row = first_centre_px(y);
    EXPECT_GE(centre_fx8(row), y);
    EXPECT_LT(centre_fx8(row - 1), y);
  }
  EXPECT_EQ(first_centre_px(-8388608), -32768);
  EXPECT_EQ(first_centre_px(8388607), 32768);
}

}  // namespace
}  // namespace selvage::mapper
