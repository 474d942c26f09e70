#include "mapper/filter_blend.h"

#include <gtest/gtest.h>

#include <array>

#include "mapper/channels.h"

namespace selvage::mapper {
namespace {

constexpr std::array<uint32_t, 6> kTexels = {0x00000000, 0xFF804001, 0x10203040,
                                             0xFFFFFFFF, 0x01020304, 0x80808080};

[[nodiscard]] selvage_texture small_texture() {
  return {kTexels.data(), 3, 2, 12, SELVAGE_RGBA8888, SELVAGE_LAYOUT_ROWS, nullptr};
}

[[nodiscard]] uint32_t blended(BlendKernel kernel, FilterPoint point, selvage_address address) {
  uint32_t pixel = 0;
  kernel({&point, 1}, small_texture(), address, reinterpret_cast<char*>(&pixel));
  return pixel;
}

TEST(Channels, SpreadAndJoin) {
  for (const uint32_t texel : kTexels) EXPECT_EQ(Channels::of(texel).texel(), texel);
  const Channels sum = Channels::of(0xFFFFFFFF) * 65536 + Channels::all(32768);
  EXPECT_EQ((sum >> 16).texel(), 0xFFFFFFFF);
}

TEST(BlendFour, IsTheMeanOfFourRoundedHalfUp) {
  // Columns 0 and 1, rows 0 and 1: bytes (0 + 1 + ff + 4), (0 + 40 + ff + 3), ... from the lowest.
  const uint32_t wanted = 0x41U | 0x51U << 8 | 0x60U << 16 | 0x80U << 24;
  EXPECT_EQ(blended(blend_four, {0, 0}, SELVAGE_ADDRESS_CLAMP), wanted);
  EXPECT_EQ(blended(blend_four, {255, 255}, SELVAGE_ADDRESS_CLAMP), wanted);
  EXPECT_EQ(blended(blend_four, {256 * 3, 256 * 2}, SELVAGE_ADDRESS_WRAP), wanted);
}

TEST(BlendFour, AddressesEachNeighbourByItself) {
  EXPECT_EQ(blended(blend_four, {-256 * 9, -256 * 9}, SELVAGE_ADDRESS_CLAMP), kTexels[0]);
  EXPECT_EQ(blended(blend_four, {256 * 9, 256 * 9}, SELVAGE_ADDRESS_CLAMP), kTexels[5]);
  // Columns 2 and 0 of rows 1 and 0: the bytes are 80 + ff + 40, 80 + ff + 30, ...
  const uint32_t wanted = 0x70U | 0x6CU << 8 | 0x68U << 16 | 0x64U << 24;
  EXPECT_EQ(blended(blend_four, {-256, -256}, SELVAGE_ADDRESS_WRAP), wanted);
  EXPECT_EQ(blended(blend_four, {-1, -1}, SELVAGE_ADDRESS_WRAP), wanted);
}

TEST(BlendBilinear, WeighsByTheFraction) {
  EXPECT_EQ(blended(blend_bilinear, {256, 0}, SELVAGE_ADDRESS_CLAMP), kTexels[1]);
  // A quarter of the way from texel 0 to texel 1: 0x40 / 4 and 0x80 / 4; 0x01 and 0xFF round.
  EXPECT_EQ(blended(blend_bilinear, {64, 0}, SELVAGE_ADDRESS_CLAMP),
            0x00U | 0x10U << 8 | 0x20U << 16 | 0x40U << 24);
  EXPECT_EQ(blended(blend_bilinear, {128, 0}, SELVAGE_ADDRESS_CLAMP),
            0x01U | 0x20U << 8 | 0x40U << 16 | 0x80U << 24);
  // Half way down from texel (0, 0) to white.
  EXPECT_EQ(blended(blend_bilinear, {0, 128}, SELVAGE_ADDRESS_CLAMP), 0x80808080);
}

TEST(BlendBilinear, ReadsNothingBeyondTheTexture) {
  EXPECT_EQ(blended(blend_bilinear, {2 * 256 + 255, 256 + 255}, SELVAGE_ADDRESS_CLAMP), kTexels[5]);
  EXPECT_EQ(blended(blend_bilinear, {-(1 << 23), 1 << 23}, SELVAGE_ADDRESS_CLAMP), kTexels[3]);
}

}  // namespace
}  // namespace selvage::mapper
