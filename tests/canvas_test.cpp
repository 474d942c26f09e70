#include "spec/canvas.h"

#include <gtest/gtest.h>

#include <cstring>

namespace selvage::spec {
namespace {

TEST(Canvas, PixelsRoundTripInEveryFormatAndDirection) {
  for (const selvage_format format : {SELVAGE_INDEX8, SELVAGE_RGB565, SELVAGE_RGBA8888}) {
    for (const bool flip : {false, true}) {
      Canvas canvas(format, 3, 4, 2, flip, 0x5A);
      const uint32_t mask = format == SELVAGE_INDEX8   ? 0xFF
                            : format == SELVAGE_RGB565 ? 0xFFFF
                                                       : ~0U;
      for (int32_t y = 0; y < 4; ++y) {
        for (int32_t x = 0; x < 3; ++x) {
          canvas.set_pixel(x, y, 0x01020304U * static_cast<uint32_t>(1 + x + 3 * y));
        }
      }
      for (int32_t y = 0; y < 4; ++y) {
        for (int32_t x = 0; x < 3; ++x) {
          EXPECT_EQ(canvas.pixel(x, y), 0x01020304U * static_cast<uint32_t>(1 + x + 3 * y) & mask);
        }
      }
      EXPECT_TRUE(canvas.guards_are_intact());
      EXPECT_EQ(canvas.image().pitch < 0, flip);
    }
  }
}

TEST(Canvas, SeesEveryByteAround) {
  for (const bool flip : {false, true}) {
    for (const ptrdiff_t beyond : {-64, -1}) {
      Canvas canvas(SELVAGE_RGBA8888, 3, 4, 2, flip, 0x5A);
      char* top = static_cast<char*>(canvas.image().pixels);
      const ptrdiff_t lowest = flip ? 3 * canvas.image().pitch : 0;
      top[lowest + beyond] = 0;
      EXPECT_FALSE(canvas.guards_are_intact());
    }
    for (const ptrdiff_t column : {12, 19}) {  // the padding
      Canvas canvas(SELVAGE_RGBA8888, 3, 4, 2, flip, 0x5A);
      static_cast<char*>(canvas.image().pixels)[column] = 0;
      EXPECT_FALSE(canvas.guards_are_intact());
    }
  }
}

}  // namespace
}  // namespace selvage::spec
