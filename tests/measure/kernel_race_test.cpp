#include "measure/kernel_race.h"

#include <gtest/gtest.h>

namespace selvage::measure {
namespace {

inline constexpr selvage_kernel kScalar = SELVAGE_KERNEL_SCALAR, kAvx2 = SELVAGE_KERNEL_AVX2,
                                kAvx512 = SELVAGE_KERNEL_AVX512;
inline constexpr mapper::KernelOrder kOrder = {kAvx512, kAvx2, SELVAGE_KERNEL_SSE4, kScalar,
                                               SELVAGE_KERNEL_NEON};

TEST(KernelRace, IsWonByTheShortestTimeOfAny) {
  KernelRace race;
  race.record(kScalar, 1000);
  EXPECT_EQ(race.winner(kOrder), kScalar);
  race.record(kAvx512, 1200);
  EXPECT_EQ(race.winner(kOrder), kScalar);
  race.record(kAvx2, 700);
  EXPECT_EQ(race.winner(kOrder), kAvx2);
}

// Whatever the machine does beside makes times longer: all but one of a kernel's may be.
TEST(KernelRace, ForgetsDisturbances) {
  KernelRace race;
  for (int round = 0; round < 10; ++round) {
    race.record(kAvx2, round == 7 ? 700 : 90000);
    race.record(kAvx512, round == 2 ? 1000 : 1001);
  }
  EXPECT_EQ(race.winner(kOrder), kAvx2);
}

TEST(KernelRace, TakesWhatDiffersLittleForEqual) {
  KernelRace race;
  race.record(kAvx2, 1600);
  race.record(kAvx512, 1700);
  EXPECT_EQ(race.winner(kOrder), kAvx512) << "a sixteenth more, and first in the order";
  race.record(kAvx2, 1599);
  EXPECT_EQ(race.winner(kOrder), kAvx2) << "more than a sixteenth";
}

TEST(KernelRace, CountsATickOfNothingAsATime) {
  KernelRace race;
  race.record(kScalar, 0);
  race.record(kAvx512, 5);
  EXPECT_EQ(race.winner(kOrder), kScalar);
}

}  // namespace
}  // namespace selvage::measure
