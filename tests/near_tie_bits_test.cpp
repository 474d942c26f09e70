// How large denominators get in a batch, and whether 64 bits are enough for near-ties there.
#include "mapper/near_tie_bits.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "spec/random.h"

namespace selvage::mapper {
namespace {

constexpr int kLargeStepBits = 80;

// Spans of any widths, none among them, one below another or not.
[[nodiscard]] SpanBatch any_batch(spec::Random& random) {
  SpanBatch batch;
  batch.first_row = random.in(-5, 5);
  batch.rows = random.in(1, 9);
  batch.widest_px = 0;
  for (size_t i = 0; i < static_cast<size_t>(batch.rows); ++i) {
    batch.left_px[i] = random.in(-20, 21);
    batch.right_px[i] = batch.left_px[i] + random.pick({0, 1, random.in(0, 30)});
    batch.widest_px = std::max(batch.widest_px, batch.right_px[i] - batch.left_px[i]);
  }
  return batch;
}

[[nodiscard]] uint128 any_step(spec::Random& random) {
  const int128 large = int128{random.in(-100, 101)} << random.in(0, kLargeStepBits);
  return static_cast<uint128>(large + random.in(-3, 4));
}

TEST(NearTieBits, TheMostOfALineIsThatOfItsBox) {
  for (uint64_t seed = 1; seed <= 3000; ++seed) {
    spec::Random random(seed);
    const SpanBatch batch = any_batch(random);
    const ExactLine line{any_step(random), any_step(random)};
    const uint128 down = any_step(random);
    int32_t left_px = batch.left_px[0], end_px = left_px + 1;
    for (int32_t i = 0; i < batch.rows; ++i) {
      left_px = std::min(left_px, batch.span(i).left_px);
      end_px = std::max(end_px, batch.span(i).right_px);
    }
    int128 most = static_cast<int128>(line.start);
    for (int32_t row = 0; row < batch.rows; ++row) {
      for (int32_t px = left_px; px < end_px; ++px) {
        const int128 right = int128{px - batch.left_px[0]} * static_cast<int128>(line.step);
        const int128 at =
            static_cast<int128>(line.start) + right + int128{row} * static_cast<int128>(down);
        most = std::max(most, at);
      }
    }
    ASSERT_TRUE(most_in_box(line, down, batch) == most) << "seed " << seed;
  }
}

TEST(NearTieBits, AreEnoughBelowAQuarterOfTheirRange) {
  for (const int bits : {64, 80}) {
    for (const int spare_bits : {0, 1, 12, 16}) {
      const double least_too_large = std::ldexp(0.25, bits + spare_bits);
      EXPECT_TRUE(are_enough(bits, std::nextafter(least_too_large, 0), spare_bits));
      EXPECT_FALSE(are_enough(bits, least_too_large, spare_bits));
      EXPECT_FALSE(are_enough(bits, HUGE_VAL, spare_bits));
    }
    EXPECT_TRUE(are_enough(bits, 1, 0));
  }
}

}  // namespace
}  // namespace selvage::mapper
