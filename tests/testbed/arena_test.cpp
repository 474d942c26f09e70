#include "testbed/arena.h"

#include <gtest/gtest.h>

namespace selvage::testbed {
namespace {

TEST(Arena, IsWholePagesBetweenGuards) {
  const Arena arena(5000);
  EXPECT_EQ(arena.range().bytes() % 4096, 0u);
  EXPECT_GE(arena.range().bytes(), 5000u);
  EXPECT_EQ(arena.guarded().bytes(), arena.range().bytes() + 2 * kGuardBytes);
  auto* bytes = reinterpret_cast<volatile char*>(arena.range().begin);
  bytes[0] = 1;
  bytes[arena.range().bytes() - 1] = 2;
  EXPECT_EQ(bytes[0] + bytes[arena.range().bytes() - 1], 3);
}

TEST(Arena, PlacesAtItsEndsAsTheUnitLets) {
  const Arena arena(4096);
  const Range range = arena.range();
  EXPECT_EQ(arena.at_end(100, 0, 1) + 100, range.end);
  EXPECT_EQ(arena.at_end(100, 0, 4) + 100, range.end) << "both are multiples of 4";
  EXPECT_EQ(arena.at_end(100, 3, 4) + 101, range.end) << "one byte is lost to the alignment";
  EXPECT_EQ(arena.at_end(100, 3, 4) % 4, 3u);
  EXPECT_EQ(arena.at_begin(8, 4), range.begin);
  EXPECT_EQ(arena.at_begin(7, 4), range.begin + 3);
}

TEST(Range, TouchesWhatItMeetsOrOverlaps) {
  const Range range{10, 20};
  EXPECT_TRUE(range.touches({20, 30}));
  EXPECT_TRUE(range.touches({5, 10}));
  EXPECT_TRUE(range.touches({12, 13}));
  EXPECT_FALSE(range.touches({21, 30}));
  EXPECT_TRUE(range.holds(10));
  EXPECT_FALSE(range.holds(20));
}

}  // namespace
}  // namespace selvage::testbed
