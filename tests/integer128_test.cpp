// Integers of 128 bits out of two of 64, against GMP's: modulo 2^128, whichever operation.
#include "mapper/integer128.h"

#include <gtest/gtest.h>

#include <gmpxx.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

#include "spec/random.h"

namespace selvage::mapper {
namespace {

using Signed = Integer128<true>;
using Unsigned = Integer128<false>;

[[nodiscard]] mpz_class power_of_two(unsigned bits) { return mpz_class(1) << bits; }

// In [0, 2^128).
[[nodiscard]] mpz_class value_of(Unsigned n) {
  const std::array parts{static_cast<uint64_t>(n), static_cast<uint64_t>(n >> 64)};
  mpz_class value;
  mpz_import(value.get_mpz_t(), parts.size(), -1, sizeof parts[0], 0, 0, parts.data());
  return value;
}
// In [-2^127, 2^127).
[[nodiscard]] mpz_class value_of(Signed n) {
  const mpz_class bits = value_of(Unsigned(n));
  return bits < power_of_two(127) ? bits : mpz_class(bits - power_of_two(128));
}

// What is left of it modulo 2^128, in the type's range.
template <class Integer>
[[nodiscard]] mpz_class wrapped(const mpz_class& n) {
  mpz_class bits;
  mpz_fdiv_r_2exp(bits.get_mpz_t(), n.get_mpz_t(), 128);
  const bool is_negative = std::is_same_v<Integer, Signed> && bits >= power_of_two(127);
  return is_negative ? mpz_class(bits - power_of_two(128)) : bits;
}

// Of any length, with runs of ones and zeros, where carries go far.
template <class Integer>
[[nodiscard]] Integer any(spec::Random& random) {
  const auto half = [&] { return random.pick({uint64_t{0}, ~uint64_t{0}, random.bits()}); };
  const Integer n = Integer(half()) << 64 | Integer(half());
  const Integer shorter = n >> random.in(0, 128);
  return random.percent(30) ? shorter + random.in(-2, 3) : shorter;
}

template <class Integer>
class Integers128 : public testing::Test {};
using Both = testing::Types<Signed, Unsigned>;
TYPED_TEST_SUITE(Integers128, Both);

TYPED_TEST(Integers128, AddSubtractAndMultiply) {
  spec::Random random(1);
  for (int i = 0; i < 100000; ++i) {
    const auto a = any<TypeParam>(random), b = any<TypeParam>(random);
    const mpz_class x = value_of(a), y = value_of(b);
    ASSERT_EQ(value_of(a + b), wrapped<TypeParam>(x + y)) << x << " " << y;
    ASSERT_EQ(value_of(a - b), wrapped<TypeParam>(x - y)) << x << " " << y;
    ASSERT_EQ(value_of(a * b), wrapped<TypeParam>(x * y)) << x << " " << y;
    ASSERT_EQ(value_of(-a), wrapped<TypeParam>(-x)) << x;
    TypeParam sum = a, rest = a;
    ASSERT_EQ(sum += b, a + b);
    ASSERT_EQ(rest -= b, a - b);
  }
}

TYPED_TEST(Integers128, CompareAsTheirValues) {
  spec::Random random(2);
  for (int i = 0; i < 100000; ++i) {
    const auto a = any<TypeParam>(random);
    const auto b = random.percent(30) ? a + random.in(-1, 2) : any<TypeParam>(random);
    ASSERT_EQ(a < b, value_of(a) < value_of(b)) << value_of(a) << " " << value_of(b);
    ASSERT_EQ(a == b, value_of(a) == value_of(b)) << value_of(a) << " " << value_of(b);
  }
}

TYPED_TEST(Integers128, Shift) {
  spec::Random random(3);
  for (int i = 0; i < 100000; ++i) {
    const auto a = any<TypeParam>(random);
    const int bits = random.percent(20) ? random.pick({0, 63, 64, 65, 127}) : random.in(0, 128);
    const mpz_class by = power_of_two(static_cast<unsigned>(bits));
    mpz_class down;
    mpz_fdiv_q(down.get_mpz_t(), value_of(a).get_mpz_t(), by.get_mpz_t());
    ASSERT_EQ(value_of(a >> bits), down) << value_of(a) << " " << bits;
    ASSERT_EQ(value_of(a << bits), wrapped<TypeParam>(value_of(a) * by)) << value_of(a);
    TypeParam left = a, right = a;
    ASSERT_EQ(left <<= bits, a << bits);
    ASSERT_EQ(right >>= bits, a >> bits);
  }
}

TYPED_TEST(Integers128, AndOrNot) {
  spec::Random random(4);
  for (int i = 0; i < 10000; ++i) {
    const auto a = any<TypeParam>(random), b = any<TypeParam>(random);
    const Unsigned x(a), y(b);
    ASSERT_EQ(value_of(Unsigned(a & b)), value_of(x) & value_of(y));
    ASSERT_EQ(value_of(Unsigned(a | b)), value_of(x) | value_of(y));
    ASSERT_EQ(value_of(~a), wrapped<TypeParam>(-value_of(a) - 1));
  }
}

TYPED_TEST(Integers128, ComeFromBuiltInOnesAndGoToThem) {
  EXPECT_EQ(value_of(TypeParam(-1)), wrapped<TypeParam>(-1)) << "the sign is extended";
  EXPECT_EQ(value_of(TypeParam(std::numeric_limits<int64_t>::min())),
            wrapped<TypeParam>(-power_of_two(63)));
  EXPECT_EQ(value_of(TypeParam(~uint64_t{0})), power_of_two(64) - 1);
  EXPECT_EQ(value_of(TypeParam(uint8_t{255})), 255);
  const auto n = TypeParam(-5) << 32 | TypeParam(7);
  EXPECT_EQ(static_cast<int32_t>(n), 7);
  EXPECT_EQ(static_cast<int64_t>(n), -5 * (int64_t{1} << 32) + 7);
  EXPECT_EQ(static_cast<int64_t>(Signed(Unsigned(n))), -5 * (int64_t{1} << 32) + 7);
}

// mpz_class goes to a double by truncation; the neighbours of that one are compared with n.
[[nodiscard]] double nearest(const mpz_class& n) {
  const double down = n.get_d(), up = std::nextafter(down, n < 0 ? -HUGE_VAL : HUGE_VAL);
  const mpz_class twice = 2 * n, middle = mpz_class(down) + mpz_class(up);
  if (twice == middle)
    return std::fmod(std::ldexp(down, -std::ilogb(down) + 52), 2) == 0 ? down : up;
  return abs(twice) < abs(middle) ? down : up;
}

TYPED_TEST(Integers128, GoToTheNearestDouble) {
  spec::Random random(5);
  const auto check = [](TypeParam n) {
    const mpz_class value = value_of(n);
    if (abs(value) <= power_of_two(53)) {
      ASSERT_EQ(static_cast<double>(n), value.get_d()) << value;
    } else {
      ASSERT_EQ(static_cast<double>(n), nearest(value)) << value;
    }
  };
  for (int i = 0; i < 100000; ++i) check(any<TypeParam>(random));
  for (int bits = 54; bits < 127; ++bits) {  // ties, and what is next to them
    for (const int64_t odd : {1, 3, (1 << 20) + 1}) {
      for (const int beside : {-1, 0, 1}) {
        const TypeParam n = (TypeParam(1) << bits) + (TypeParam(odd) << (bits - 53)) + beside;
        check(n);
        check(-n);
      }
    }
  }
  check(~TypeParam(0));
  check(~TypeParam(0) >> 1);
  check(TypeParam(1) << 127);
}

}  // namespace
}  // namespace selvage::mapper
