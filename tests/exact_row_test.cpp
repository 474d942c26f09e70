#include "mapper/exact_row.h"

#include <gtest/gtest.h>

#include "spec/random.h"

namespace selvage::mapper {
namespace {

inline constexpr uint128 kShort = uint128{1} << 62;

[[nodiscard]] ExactRow row_of(uint128 n, uint128 d, uint128 d_step) {
  return {{n, 0}, {0, 0}, {d, d_step}};
}

// A unit below a whole number, at it and a unit above, whichever halves are looked at.
TEST(ExactRow, TellsTheLeastMissFromATouch) {
  spec::Random random(1);
  for (int i = 0; i < 2000; ++i) {
    const int bits = random.in(1, 62);
    const uint64_t d = (uint64_t{1} << bits) | (random.bits() & ((uint64_t{1} << bits) - 1));
    const int32_t whole = random.pick({0, 1, -1, 32768, -32768, random.in(-32768, 32769)});
    const uint128 tie = static_cast<uint128>(int128{whole}) * d;
    for (const int beyond : {-1, 0, 1}) {
      const uint128 n = tie + static_cast<uint128>(int128{beyond});
      ASSERT_EQ(reaches(n, uint128{d}, whole), beyond >= 0) << d << " " << whole;
      ASSERT_EQ(reaches(static_cast<uint64_t>(n), d, whole), beyond >= 0) << d << " " << whole;
    }
    // A whole texel off, the most there is.
    ASSERT_TRUE(reaches(static_cast<uint64_t>(tie + d), d, whole));
    ASSERT_FALSE(reaches(static_cast<uint64_t>(tie - d), d, whole));
  }
}

// The low halves of a denominator that varies, or is longer, tell nothing.
TEST(ExactRow, IsShortWhereLowHalvesTellTheSign) {
  EXPECT_TRUE(row_of(0, 1, 0).is_short());
  EXPECT_TRUE(row_of(0, kShort - 1, 0).is_short());
  EXPECT_FALSE(row_of(0, kShort, 0).is_short());
  EXPECT_FALSE(row_of(0, kShort << 10, 0).is_short());
  EXPECT_FALSE(row_of(0, uint128{1} << 100, 0).is_short());
  for (const uint128 step : {uint128{1}, uint128{1} << 16, ~uint128{0}}) {
    EXPECT_FALSE(row_of(0, 1 << 16, step).is_short());
  }
}

TEST(ExactRow, StepsItsNumeratorsAndDenominator) {
  const ExactRow row{{5, 7}, {100, ~uint128{0}}, {uint128{1} << 40, uint128{1} << 16}};
  EXPECT_TRUE(row.u.at(3) == 26);
  EXPECT_TRUE(row.v.at(3) == 97);
  EXPECT_EQ(row.u.at<uint64_t>(65535), 5U + 7U * 65535U);
  EXPECT_TRUE(row.finer_d(8).start == uint128{1} << 32);
  EXPECT_TRUE(row.finer_d(8).step == uint128{1} << 8);
}

}  // namespace
}  // namespace selvage::mapper
