#include "mapper/copy_row.h"

#include <gtest/gtest.h>

#include <vector>

#include "spec/canvas.h"
#include "spec/exact.h"
#include "spec/texture_memory.h"

namespace selvage::mapper {
namespace {

constexpr int32_t kCopiedWidth_texel = 11, kCopiedHeight_texel = 6, kLongest_px = 27,
                  kBeside_px = 2;

// A row of some pixels from texel (s, t) on: each against the address mode, and nothing written
// beside it.
void expect_copied(const selvage_texture& texture, selvage_address address, int32_t s, int32_t t,
                   int32_t width_px) {
  spec::Canvas row(texture.format, kLongest_px + 2 * kBeside_px, 1, 0, false, 0);
  const selvage_image image = row.image();
  const ptrdiff_t bytes = image.pitch / image.width;
  copy_row(texture, address, s, t, width_px, static_cast<char*>(image.pixels) + kBeside_px * bytes);
  for (int32_t x = 0; x < image.width; ++x) {
    const int32_t i = x - kBeside_px;
    const int32_t column = spec::address_texel(s + i, kCopiedWidth_texel, address);
    const int32_t line = spec::address_texel(t, kCopiedHeight_texel, address);
    const bool inside = 0 <= i && i < width_px;
    const uint32_t wanted = inside ? static_cast<uint32_t>(1 + column + 16 * line) : 0U;
    ASSERT_EQ(row.pixel(x, 0), wanted) << s << ", " << t << ", " << width_px << ", " << x;
  }
}

// Every start and length about a small texture, in every format and layout.
TEST(CopyRow, CopiesTheAddressedTexels) {
  spec::Case c;
  c.texture_width_texel = kCopiedWidth_texel;
  c.texture_height_texel = kCopiedHeight_texel;
  c.padding_px = 1;
  c.flip_texture = true;
  for (const selvage_format format : {SELVAGE_INDEX8, SELVAGE_RGB565, SELVAGE_RGBA8888}) {
    for (const spec::Layout layout : {spec::Layout::kGiven, spec::Layout::kTiled}) {
      c.format = format;
      c.layout = layout;
      const spec::TextureMemory texels(
          spec::built_in(), c,
          [](spec::Texel at) { return static_cast<uint32_t>(1 + at.s + 16 * at.t); }, 0xEE);
      for (const selvage_address address : {SELVAGE_ADDRESS_CLAMP, SELVAGE_ADDRESS_WRAP}) {
        for (int32_t s = -25; s <= 25; ++s) {
          for (int32_t t = -7; t <= 7; ++t) {
            const int32_t width_px = 1 + (s + 25 + 3 * (t + 7)) % kLongest_px;
            ASSERT_NO_FATAL_FAILURE(expect_copied(texels.view(), address, s, t, width_px));
          }
        }
      }
    }
  }
}

}  // namespace
}  // namespace selvage::mapper
