#include "mapper/quotient.h"

#include <gtest/gtest.h>

#include "spec/random.h"

namespace selvage::mapper {
namespace {

// Divisors of all sizes, up to the greatest there is.
[[nodiscard]] uint64_t any_divisor(spec::Random& random) {
  if (random.percent(20)) return ~uint64_t{0} - random.bits() % 3;
  const uint64_t top = uint64_t{1} << random.in(0, 64);
  return top | (random.bits() & (top - 1));
}

// At an end of its range, next to one or anywhere.
[[nodiscard]] uint64_t any_rest(spec::Random& random, uint64_t d) {
  if (random.percent(40)) return random.bits() % d;
  const uint64_t beside = random.bits() % 3 % d;
  return random.percent(50) ? beside : d - 1 - beside;
}

[[nodiscard]] uint128 numerator(const Quotient& q, uint64_t d) {
  return static_cast<uint128>(int128{q.whole}) * d + q.rest;
}

void expect_equal(const Quotient& quotient, const Quotient& expected, uint64_t d) {
  ASSERT_EQ(quotient.whole, expected.whole) << "divisor " << d;
  ASSERT_EQ(quotient.rest, expected.rest) << "divisor " << d;
}

TEST(Quotient, IsFoundFromItsFloorAndFromOneLess) {
  spec::Random random(1);
  for (int i = 0; i < 20000; ++i) {
    const uint64_t d = any_divisor(random);
    const Quotient expected{random.in(-40000, 40000), any_rest(random, d)};
    for (const int32_t less : {0, 1}) {
      expect_equal(quotient_from(numerator(expected, d), d, expected.whole - less), expected, d);
    }
  }
}

// The sum of two remainders may be the divisor, a unit less, or more than 64 bits hold.
TEST(Quotient, IsAddedWithoutError) {
  spec::Random random(2);
  for (int i = 0; i < 20000; ++i) {
    const uint64_t d = any_divisor(random);
    const Quotient a{random.in(-40000, 40000), any_rest(random, d)};
    const uint64_t others[] = {any_rest(random, d), d - 1 - a.rest, a.rest == 0 ? 0 : d - a.rest};
    for (const uint64_t rest : others) {
      const Quotient b{random.in(-40000, 40000), rest};
      const uint128 rests = uint128{a.rest} + b.rest;
      const bool carries = rests >= d;
      expect_equal(
          sum(a, b, d),
          {a.whole + b.whole + (carries ? 1 : 0), static_cast<uint64_t>(rests - (carries ? d : 0))},
          d);
    }
  }
}

}  // namespace
}  // namespace selvage::mapper
