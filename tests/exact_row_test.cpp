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

// By the most that the denominator is at a row's pixels, its first or its last, and by how near
// near-ties are.
TEST(ExactRow, IsShortWhereLowHalvesTellTheSign) {
  const auto is_short = [](uint128 d, uint128 step, int32_t width_px, int spare_bits) {
    return row_of(0, d, step).is_short(width_px, spare_bits);
  };
  EXPECT_TRUE(is_short(1, 0, 1, 0));
  for (const int spare_bits : {0, 1, 7, 23, 32}) {
    const uint128 end = kShort << spare_bits;
    EXPECT_TRUE(is_short(end - 1, 0, 100, spare_bits));
    EXPECT_FALSE(is_short(end, 0, 100, spare_bits));
    EXPECT_TRUE(is_short(end - 100, 1, 100, spare_bits));
    EXPECT_FALSE(is_short(end - 99, 1, 100, spare_bits)) << "the last";
    EXPECT_TRUE(is_short(end - 1, ~uint128{0}, 100, spare_bits));
    EXPECT_FALSE(is_short(end, ~uint128{0}, 100, spare_bits)) << "the first";
  }
}

// A near-tie next to a whole number of a denominator far longer than 64 bits.
TEST(ExactRow, TellsNearTiesOfLongDenominatorsByTheirLowHalves) {
  spec::Random random(2);
  for (int i = 0; i < 2000; ++i) {
    const int spare_bits = random.in(1, 33);
    const uint128 d = (kShort << spare_bits) - 1 - (random.bits() >> 3);
    ASSERT_TRUE(row_of(0, d, 0).is_short(1, spare_bits));
    const int32_t whole = random.pick({0, 1, -1, 32768, -32768, random.in(-32768, 32769)});
    const uint128 most = d >> spare_bits;
    for (const uint128 off : {uint128{0}, uint128{1}, most, 0 - uint128{1}, 0 - most}) {
      const uint128 n = static_cast<uint128>(int128{whole}) * d + off;
      const bool beyond = static_cast<int128>(off) >= 0;
      ASSERT_EQ(reaches(n, d, whole), beyond);
      ASSERT_EQ(reaches(static_cast<uint64_t>(n), static_cast<uint64_t>(d), whole), beyond);
    }
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
