#include "testbed/arena.h"

#include <gtest/gtest.h>

#include <vector>

#include "testbed/fence.h"

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

TEST(Packer, PlacesAtTheEndsAsTheUnitLets) {
  const Range room{4096, 8192};
  const auto last = [&](size_t bytes, uintptr_t like, size_t unit) {
    return Packer(room, true).place(bytes, like, unit);
  };
  const auto first = [&](size_t bytes, uintptr_t like, size_t unit) {
    return Packer(room, false).place(bytes, like, unit);
  };
  EXPECT_EQ(last(100, 0, 1), 8092u);
  EXPECT_EQ(last(100, 0, 4), 8092u) << "both are multiples of 4";
  EXPECT_EQ(last(100, 3, 4), 8091u) << "one byte is lost to the alignment";
  EXPECT_EQ(first(100, 8, 4), 4096u);
  EXPECT_EQ(first(100, 7, 4), 4099u);
  EXPECT_EQ(last(4096, 0, 4), 4096u);
  EXPECT_EQ(last(4096, 1, 4), std::nullopt);
  EXPECT_EQ(first(4097, 0, 1), std::nullopt);
}

TEST(Packer, GoesOnWhereItWas) {
  Packer down({4096, 8192}, true), up({4096, 8192}, false);
  EXPECT_EQ(down.place(10, 0, 4), 8180u);
  EXPECT_EQ(down.place(4, 0, 4), 8176u);
  EXPECT_EQ(down.bytes_left(), 4080u);
  EXPECT_EQ(up.place(10, 0, 4), 4096u);
  EXPECT_EQ(up.place(4, 0, 4), 4108u);
  EXPECT_EQ(up.bytes_left(), 4080u);
}

TEST(Fence, TellsWhatWasWrittenBesideTheMemory) {
  std::vector<uint8_t> room(100, 0);
  const auto at = [&](size_t i) { return reinterpret_cast<uintptr_t>(room.data() + i); };
  const Fence fence({at(0), at(100)}, {at(10), at(90)});
  room[10] = room[89] = 1;
  EXPECT_EQ(fence.fault("field"), "");
  room[91] = 1;
  EXPECT_EQ(fence.fault("field"), "wrote 1 byte after the end of the field");
  room[90] = 1;
  EXPECT_EQ(fence.fault("field"), "wrote just after the end of the field");
  const Fence other({at(0), at(100)}, {at(10), at(90)});
  room[8] = 1;
  EXPECT_EQ(other.fault("field"), "wrote 2 bytes before the start of the field");
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
