#include "mapper/wide.h"

#include <gtest/gtest.h>

#include <gmpxx.h>

#include <algorithm>
#include <compare>

#include "spec/random.h"
#include "tests/whole.h"

namespace selvage::mapper {
namespace {

[[nodiscard]] mpz_class wide_value(const Wide& n) { return (whole(n.high) << 128) + whole(n.low); }

// Of any length up to the given one, or just below a power of two.
[[nodiscard]] uint128 any_unsigned(spec::Random& random, int most_bits) {
  const int bits = random.in(0, most_bits + 1);
  if (bits == 0) return 0;
  const uint128 mask = ~uint128{0} >> (128 - bits);
  const uint128 number = (uint128{random.bits()} << 64 | random.bits()) & mask;
  return random.percent(30) ? mask - (number & 1) : number;
}

[[nodiscard]] int128 any_signed(spec::Random& random, int most_bits) {
  const auto number = static_cast<int128>(any_unsigned(random, most_bits));
  return random.percent(50) ? -number : number;
}

TEST(Wide, ComparesTheHighHalvesFirst) {
  constexpr auto kLess = std::strong_ordering::less, kEqual = std::strong_ordering::equal,
                 kGreater = std::strong_ordering::greater;
  EXPECT_EQ((Wide{1, 5} <=> Wide{1, 5}), kEqual);
  EXPECT_EQ((Wide{1, 4} <=> Wide{1, 5}), kLess);
  EXPECT_EQ((Wide{1, 6} <=> Wide{1, 5}), kGreater);
  EXPECT_EQ((Wide{0, 6} <=> Wide{1, 5}), kLess);
  EXPECT_EQ((Wide{2, 4} <=> Wide{1, 5}), kGreater);
}

TEST(Wide, IsEqualWhereBothHalvesAre) {
  EXPECT_EQ((Wide{1, 5}), (Wide{1, 5}));
  EXPECT_NE((Wide{1, 5}), (Wide{1, 4}));
  EXPECT_NE((Wide{1, 5}), (Wide{2, 5}));
}

TEST(Wide, MagnitudesHaveNoSign) {
  for (const int n : {0, 1, 2, 77}) {
    EXPECT_TRUE(magnitude(n) == static_cast<uint128>(n)) << n;
    EXPECT_TRUE(magnitude(-n) == static_cast<uint128>(n)) << n;
  }
}

TEST(Wide, MultipliesAddsAndCompares) {
  spec::Random random(1);
  for (int i = 0; i < 20000; ++i) {
    const uint128 a = any_unsigned(random, 128), b = any_unsigned(random, 128);
    const uint128 c = any_unsigned(random, 127), d = any_unsigned(random, 127);
    const Wide p = product(a, b), r = product(c, d);
    ASSERT_EQ(wide_value(p), whole(a) * whole(b));
    ASSERT_EQ(p < r, wide_value(p) < wide_value(r));
    ASSERT_EQ(p == r, wide_value(p) == wide_value(r));
    const Wide half = product(a >> 1, b);
    ASSERT_EQ(wide_value(half + r), wide_value(half) + wide_value(r));
    ASSERT_EQ(wide_value(std::max(p, r) - std::min(p, r)),
              abs(mpz_class(wide_value(p) - wide_value(r))));
  }
}

TEST(Wide, OrdersByTheHighPartFirst) {
  const Wide low{0, ~uint128{0}}, high{1, 0};
  EXPECT_LT(low, high);
  EXPECT_EQ(low + Wide(0, 1), high);
  EXPECT_EQ(high - Wide(0, 1), low);
}

TEST(Wide, TakesDistancesOfProductsOfEitherSign) {
  spec::Random random(2);
  for (int i = 0; i < 20000; ++i) {
    const int128 a = any_signed(random, 127), b = any_signed(random, 127);
    const int128 c = any_signed(random, 127), d = random.percent(20) ? a : any_signed(random, 127);
    const mpz_class wanted = abs(mpz_class(whole(a) * whole(b) - whole(c) * whole(d)));
    ASSERT_EQ(wide_value(distance(a, b, c, d)), wanted);
  }
}

}  // namespace
}  // namespace selvage::mapper
