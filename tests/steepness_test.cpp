// The bound on the steps along a span in perspective, against exact rational numbers.
#include "mapper/steepness.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "spec/exact.h"
#include "spec/random.h"

namespace selvage::mapper {
namespace {

using Linear = DividedLanes::Linear;

[[nodiscard]] spec::Rational exact_at(const Linear& line, int32_t i) {
  return spec::Rational(line.start) + i * spec::Rational(line.step);
}

// The most that the quotient changes by from a pixel to the next.
[[nodiscard]] spec::Rational steepest(const Linear& numerator, const Linear& denominator,
                                      int32_t width_px) {
  spec::Rational most = 0;
  for (int32_t i = 0; i + 1 < width_px; ++i) {
    const spec::Rational change = exact_at(numerator, i + 1) / exact_at(denominator, i + 1) -
                                  exact_at(numerator, i) / exact_at(denominator, i);
    most = std::max(most, spec::Rational(abs(change)));
  }
  return most;
}

[[nodiscard]] double any_within(spec::Random& random, double most) {
  return most * random.in(-1'000'000, 1'000'001) / 1e6;
}

// Of denominators from 1 up, to the right or to the left.
[[nodiscard]] Linear any_denominator(spec::Random& random, int32_t width_px) {
  const double rise = 1e-3 + std::abs(any_within(random, 3));
  const Linear up{1, rise / width_px};
  return random.percent(50) ? up : Linear{1 + rise, -up.step};
}

TEST(Steepness, IsNoLessThanAnyStepWhereItCancels) {
  spec::Random random(1);
  for (int i = 0; i < 4000; ++i) {
    const int32_t width_px = random.in(2, 40);
    const Linear d = any_denominator(random, width_px);
    // u is nearly the same everywhere, and far from 0 on either side.
    const double u_fx32 = any_within(random, 0x1p47),
                 tilt = 1 + any_within(random, random.pick({0.0, 0x1p-52, 0x1p-49}));
    const Linear numerator{u_fx32 * d.start, u_fx32 * d.step * tilt};
    const double bound_fx32 = steepest_fx32(numerator, d, width_px);
    ASSERT_GE(spec::Rational(bound_fx32), steepest(numerator, d, width_px)) << "case " << i;
    const double least = std::min(d.start, d.start + (width_px - 1) * d.step);
    const double terms = 2 * std::abs(u_fx32 * d.step * d.start);
    const double hidden_fx32 = kHiddenByCancellation * terms / (least * least);
    ASSERT_NEAR(bound_fx32, hidden_fx32, 0.01 * hidden_fx32) << "case " << i;
  }
}

TEST(Steepness, IsThatOfTheLeastDenominator) {
  spec::Random random(2);
  for (int i = 0; i < 4000; ++i) {
    const int32_t width_px = random.in(2, 40);
    const Linear d = any_denominator(random, width_px);
    const Linear numerator{any_within(random, 0x1p36), any_within(random, 0x1p32)};
    const double bound_fx32 = steepest_fx32(numerator, d, width_px);
    ASSERT_GE(spec::Rational(bound_fx32), steepest(numerator, d, width_px)) << "case " << i;
    const double least = std::min(d.start, d.start + (width_px - 1) * d.step);
    const double slope = std::abs(numerator.step * d.start - numerator.start * d.step);
    ASSERT_NEAR(bound_fx32, slope / (least * least), 1) << "case " << i;
  }
}

}  // namespace
}  // namespace selvage::mapper
