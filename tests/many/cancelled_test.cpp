// A caller's oneTBB tasks may be cancelled. What it asked of selvage_draw_many is drawn all the
// same.
#include <gtest/gtest.h>
#include <tbb/task_group.h>

#include "support.h"

namespace selvage::many {
namespace {

TEST(Cancelled, DrawsAll) {
  for (const size_t count : {30U, 3000U}) {
    const List list(count, /*seed=*/count);
    const Target expected = drawn(list, 1);
    Target target;
    tbb::task_group group;
    group.run_and_wait([&] {
      group.cancel();
      target = drawn(list, 4);
    });
    EXPECT_TRUE(target == expected) << count << " polygons";
  }
}

}  // namespace
}  // namespace selvage::many
