// oneTBB gives its threads the mode of rounding of who uses it first. That may be
// selvage_draw_many, which rounds to the nearest for itself alone.
#include <gtest/gtest.h>
#include <tbb/parallel_for.h>

#include <atomic>
#include <cfenv>
#include <thread>

#include "support.h"

namespace selvage::many {
namespace {

// Vertices on half pixels and whole texels: of many pixels u or v is whole.
[[nodiscard]] Target drawn_on_ties(uint64_t seed, int32_t threads) {
  List list(60, seed);
  for (selvage_vertex& v : list.vertices) {
    v.x &= ~127, v.y &= ~127;
    v.u &= ~0xFFFF, v.v &= ~0xFFFF;
  }
  return drawn(list, threads);
}

// On a thread that nobody has used oneTBB from.
template <class Body>
void on_a_new_thread(const Body& body) {
  std::thread thread(body);
  thread.join();
}

TEST(Rounding, OfThreadsChangesNoPixel) {
  for (const int mode : {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
    for (uint64_t seed = 1; seed <= 10; ++seed) {
      const Target expected = drawn_on_ties(seed, 1);
      Target target;
      on_a_new_thread([&] {
        ASSERT_EQ(std::fesetround(mode), 0);
        target = drawn_on_ties(seed, 4);
        EXPECT_EQ(std::fegetround(), mode);
      });
      EXPECT_TRUE(target == expected) << "mode " << mode << ", seed " << seed;
    }
  }
}

TEST(Rounding, OfTheCallersThreadsStaysAsItWas) {
  constexpr int kTasks = 1000;
  std::atomic<int> up{0};
  on_a_new_thread([&] {
    ASSERT_EQ(std::fesetround(FE_UPWARD), 0);
    static_cast<void>(drawn_on_ties(1, 4));
    tbb::parallel_for(0, kTasks, [&](int) {
      volatile double one = 1, tiny = 0x1p-60;
      up += one + tiny > 1 ? 1 : 0;
    });
  });
  EXPECT_EQ(up, kTasks);
}

#if defined(__SSE2__) && defined(__GLIBC__)  // not all processors can trap
TEST(Rounding, MayTrap) {
  const Target expected = drawn_on_ties(1, 1);
  Target target;
  on_a_new_thread([&] {
    ASSERT_NE(feenableexcept(FE_ALL_EXCEPT), -1);
    target = drawn_on_ties(1, 3);  // shares of a third are inexact
    EXPECT_EQ(fedisableexcept(FE_ALL_EXCEPT), FE_ALL_EXCEPT);
  });
  EXPECT_TRUE(target == expected);
}
#endif

}  // namespace
}  // namespace selvage::many
