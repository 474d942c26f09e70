#include "mapper/copy_row.h"

#include <gtest/gtest.h>

#include <vector>

#include "spec/canvas.h"
#include "spec/exact.h"

namespace selvage::mapper {
namespace {

// Every start and length about a small texture, in every format: each pixel against the address
// mode, and nothing written beside the row.
TEST(CopyRow, CopiesTheAddressedTexels) {
  constexpr int32_t kWidth = 5, kHeight = 3, kLongest = 17, kBeside = 2;
  for (const selvage_format format : {SELVAGE_INDEX8, SELVAGE_RGB565, SELVAGE_RGBA8888}) {
    spec::Canvas texels(format, kWidth, kHeight, 1, true, 0xEE);
    for (int32_t t = 0; t < kHeight; ++t) {
      for (int32_t s = 0; s < kWidth; ++s)
        texels.set_pixel(s, t, static_cast<uint32_t>(1 + s + 8 * t));
    }
    for (const selvage_address address : {SELVAGE_ADDRESS_CLAMP, SELVAGE_ADDRESS_WRAP}) {
      for (int32_t s = -12; s <= 12; ++s) {
        for (int32_t t = -4; t <= 4; ++t) {
          const int32_t width = 1 + (s + 12 + t + 4) % kLongest;
          spec::Canvas row(format, kLongest + 2 * kBeside, 1, 0, false, 0);
          const selvage_image image = row.image();
          const ptrdiff_t bytes = image.pitch / image.width;
          copy_row(texels.texture(), address, s, t, width,
                   static_cast<char*>(image.pixels) + kBeside * bytes);
          for (int32_t x = 0; x < image.width; ++x) {
            const int32_t i = x - kBeside;
            const bool inside = 0 <= i && i < width;
            const uint32_t wanted = inside
                                        ? texels.pixel(spec::address_texel(s + i, kWidth, address),
                                                       spec::address_texel(t, kHeight, address))
                                        : 0U;
            ASSERT_EQ(row.pixel(x, 0), wanted) << s << ", " << t << ", " << width << ", " << x;
          }
        }
      }
    }
  }
}

}  // namespace
}  // namespace selvage::mapper
