// oneTBB gives threads the mode of rounding of who first used them. Ours round to the nearest.
#include <gtest/gtest.h>
#include <tbb/parallel_for.h>

#include <atomic>
#include <cfenv>
#include <cstddef>
#include <thread>

#include "many/share_out.h"
#include "mapper/nearest_rounding.h"

namespace selvage::many {
namespace {

TEST(WorkersRounding, IsToTheNearest) {
  std::atomic<int> nearest{0};
  std::thread user([&] {
    ASSERT_EQ(std::fesetround(FE_UPWARD), 0);
    tbb::parallel_for(0, 100, [](int) {});
    share_out(1000, 4, [&](size_t) { nearest += mapper::rounds_to_nearest() ? 1 : 0; });
    EXPECT_EQ(std::fegetround(), FE_UPWARD);
  });
  user.join();
  EXPECT_EQ(nearest, 1000);
}

}  // namespace
}  // namespace selvage::many
