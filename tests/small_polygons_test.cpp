// Small polygons, which kernels may draw several at a call: each kernel draws them as the scalar
// one does, one after another.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <numeric>
#include <vector>

#include "mapper/image.h"
#include "spec/random.h"
#include "spec/vertex_units.h"
#include "tests/any_small_polygons.h"
#include "tests/fenced_bytes.h"
#include "tests/small_support.h"

namespace selvage::mapper {
namespace {

using spec::kPixel_fx8;
using spec::kTexel_fx16;

// A block of seeds.
class SmallPolygonsOf : public testing::TestWithParam<uint64_t> {
 protected:
  static constexpr uint64_t kSeeds = 8000;
};

TEST_P(SmallPolygonsOf, EveryKernelDrawsAsTheScalarOneDoes) {
  for (uint64_t seed = GetParam() * kSeeds + 1; seed <= (GetParam() + 1) * kSeeds; ++seed) {
    spec::Random random(seed);
    const spec::Case c = any_small_case(random);
    ASSERT_NO_FATAL_FAILURE(expect_list_drawn_alike(c, any_small_outlines(random, c), seed));
  }
}

INSTANTIATE_TEST_SUITE_P(Block, SmallPolygonsOf, testing::Range(uint64_t{0}, uint64_t{5}));

// Each by the mapping that a call for itself would choose.
TEST(SmallPolygons, AreMappedAsByACallEachWithinATolerance) {
  for (uint64_t seed = 1; seed <= 3000; ++seed) {
    spec::Random random(seed);
    const spec::Case c = any_small_case(random);
    const std::vector<SmallOutline> outlines = any_small_outlines(random, c);
    const spec::TextureMemory texture = texture_of(c);
    const int32_t tolerance = random.pick({1, kTexel_fx16 / 16, kTexel_fx16});
    for (const selvage_kernel kernel : usable_kernels()) {
      const DrawnBy by{kernel, 1, tolerance};
      ASSERT_TRUE(draw_together(c, texture.view(), outlines, by) ==
                  draw_each(c, texture.view(), outlines, by))
          << "kernel " << kernel << ", tolerance " << tolerance << ", seed " << seed;
    }
  }
}

// Its first byte lies behind a page that may not be read, or its last byte before one.
TEST(SmallPolygons, ReadNoTexelBesideTheTexture) {
  for (uint64_t seed = 1; seed <= 4000; ++seed) {
    SCOPED_TRACE(seed);
    spec::Random random(seed);
    const spec::Case c = any_small_case(random);
    const std::vector<SmallOutline> outlines = any_small_outlines(random, c);
    const ptrdiff_t pitch = c.texture_width_texel * ptrdiff_t{bytes_per_pixel(c.format)};
    const auto bytes = static_cast<size_t>(pitch * c.texture_height_texel);
    const FencedBytes texels(bytes,
                             random.pick({FencedBytes::Side::kFirst, FencedBytes::Side::kLast}));
    std::memset(texels.first(), 0x3C, bytes);
    const ptrdiff_t last_row = c.flip_texture ? pitch * (c.texture_height_texel - 1) : 0;
    const selvage_texture texture{texels.first() + last_row,
                                  c.texture_width_texel,
                                  c.texture_height_texel,
                                  c.flip_texture ? -pitch : pitch,
                                  c.format,
                                  SELVAGE_LAYOUT_ROWS,
                                  nullptr};
    for (const selvage_kernel kernel : usable_kernels()) {
      static_cast<void>(draw_together(c, texture, outlines, {kernel}));
    }
  }
}

// A list, clipped, on some rows, which are returned one after another.
template <class Pixel>
[[nodiscard]] std::vector<Pixel> rows_drawn(selvage_format format, char* first_row, ptrdiff_t pitch,
                                            selvage_kernel kernel) {
  constexpr int32_t kWidth_px = 40, kRows = 10, kSide_texel = 32;
  std::vector<Pixel> texels(size_t{kSide_texel} * kSide_texel);
  std::iota(texels.begin(), texels.end(), Pixel{1});
  const selvage_texture texture{
      texels.data(), kSide_texel,         kSide_texel, kSide_texel * ptrdiff_t{sizeof(Pixel)},
      format,        SELVAGE_LAYOUT_ROWS, nullptr};
  const selvage_image target{first_row, kWidth_px, kRows, pitch, format};
  std::vector<SmallOutline> outlines;
  for (int32_t i = 0; i < 11; ++i) {
    const int32_t x_fx8 = i * 3 * kPixel_fx8 + 17, u_fx16 = i * kTexel_fx16;
    outlines.push_back({{x_fx8, 30 * i, u_fx16, kTexel_fx16, 1},
                        {x_fx8 + 9 * kPixel_fx8, 100 + 40 * i, u_fx16 + 7 * kTexel_fx16, 0, 1},
                        {x_fx8 + kPixel_fx8, 2500 - 40 * i, u_fx16, 20 * kTexel_fx16, 1}});
  }
  std::vector<selvage_polygon> polygons;
  for (const SmallOutline& outline : outlines) {
    polygons.push_back({outline.data(), outline.size(), &texture});
  }
  selvage_options options{};
  options.kernel = kernel;
  const size_t bytes = selvage_draw_many_bytes(polygons.size());
  std::vector<std::max_align_t> scratch(bytes / sizeof(std::max_align_t) + 1);
  const selvage_rect clip{2, 1, kWidth_px, kRows - 1};
  EXPECT_EQ(selvage_draw_many(&target, &clip, polygons.data(), polygons.size(), &options, 1,
                              scratch.data(), bytes, nullptr),
            SELVAGE_OK);
  std::vector<Pixel> pixels(size_t{kWidth_px} * kRows);
  for (int32_t row = 0; row < kRows; ++row) {
    std::memcpy(pixels.data() + row * kWidth_px, first_row + row * pitch,
                kWidth_px * sizeof(Pixel));
  }
  return pixels;
}

// 32 bits hold how many bytes one row is from the next, but not from the one nine rows away: where
// addresses have more.
constexpr ptrdiff_t kFar = std::min(ptrdiff_t{1} << 28, PTRDIFF_MAX / 16 + 1);

template <class Pixel>
void expect_far_rows_alike(selvage_format format) {
  constexpr ptrdiff_t kNear = 160, kLastRow = 9 * kFar;
  std::vector<char> near(10 * kNear);
  const auto wanted = rows_drawn<Pixel>(format, near.data(), kNear, SELVAGE_KERNEL_SCALAR);
  ASSERT_GT(std::count_if(wanted.begin(), wanted.end(), [](Pixel p) { return p != 0; }), 150);
  for (const selvage_kernel kernel : usable_kernels()) {
    for (const bool up : {false, true}) {
      const FencedBytes memory(kLastRow + kNear, FencedBytes::Side::kFirst);
      EXPECT_EQ(up ? rows_drawn<Pixel>(format, memory.first() + kLastRow, -kFar, kernel)
                   : rows_drawn<Pixel>(format, memory.first(), kFar, kernel),
                wanted)
          << "kernel " << kernel;
    }
  }
}

TEST(SmallPolygons, RowsMayBeFarApart) {
  expect_far_rows_alike<uint8_t>(SELVAGE_INDEX8);
  expect_far_rows_alike<uint16_t>(SELVAGE_RGB565);
  expect_far_rows_alike<uint32_t>(SELVAGE_RGBA8888);
}

}  // namespace
}  // namespace selvage::mapper
