#include "historic/rounded_walk.h"

#include <gtest/gtest.h>

#include <cstdint>

#include "spec/exact.h"

namespace selvage::historic {
namespace {

[[nodiscard]] int32_t rounded(int64_t a, int64_t b, int64_t steps, int64_t unit, int64_t step) {
  spec::Rational value(static_cast<long>(a * steps + (b - a) * step),
                       static_cast<long>(steps * unit));
  value.canonicalize();
  return spec::floor(value + spec::Rational(1, 2));
}

void expect_exact(int64_t a, int64_t b, int64_t steps, int64_t unit) {
  RoundedWalk walk(a, b, steps, unit);
  const RoundedWalk start = walk;
  for (int32_t step = 0; step <= steps; ++step) {
    const int32_t wanted = rounded(a, b, steps, unit, step);
    ASSERT_EQ(walk.texel(), wanted) << a << " to " << b << " in " << steps << ", step " << step;
    ASSERT_EQ(start.texel(step), wanted);
    walk.step();
  }
}

TEST(RoundedWalk, IsRoundedHalfUpAtEveryStep) {
  for (int64_t a = -9; a <= 9; ++a) {
    for (int64_t b = -9; b <= 9; ++b) {
      for (int64_t steps = 1; steps <= 12; ++steps) {
        expect_exact(a, b, steps, 1);
        expect_exact(a, b, steps, 4);
      }
    }
  }
}

TEST(RoundedWalk, HoldsTheEndsOfEveryRange) {
  for (const int64_t steps : {1, 3, 65535}) {
    RoundedWalk walk(INT32_MIN, INT32_MAX, steps, 65536);
    EXPECT_EQ(walk.texel(), -32768);
    walk.advance(steps);
    EXPECT_EQ(walk.texel(), 32768);
  }
}

TEST(RoundedWalk, TellsUnitAndConstantSteps) {
  EXPECT_TRUE(RoundedWalk(3, 10, 7, 1).is_unit());
  EXPECT_FALSE(RoundedWalk(3, 11, 7, 1).is_unit());
  EXPECT_FALSE(RoundedWalk(10, 3, 7, 1).is_unit());
  EXPECT_FALSE(RoundedWalk(3, 9, 7, 1).is_unit());
  EXPECT_TRUE(RoundedWalk(3, 3, 7, 1).is_constant());
  EXPECT_FALSE(RoundedWalk(3, 4, 7, 1).is_constant());
  EXPECT_FALSE(RoundedWalk(4, 3, 7, 1).is_constant());
}

}  // namespace
}  // namespace selvage::historic
