// No kernel reads beyond a texture: its first byte lies behind a page that may not be read, or its
// last byte before one.
#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

#include "spec/random.h"
#include "tests/fenced_bytes.h"
#include "tests/kernel_support.h"

namespace selvage::mapper {
namespace {

struct BorderDrawing {
  selvage_format format;
  selvage_options options;
  int32_t width_texel, height_texel;
  std::vector<selvage_vertex> vertices;
};

// About one of the texture's four corners, at most a texel a pixel in most.
[[nodiscard]] BorderDrawing about_a_corner(uint64_t seed, int32_t side_px) {
  static constexpr int32_t kSizes[] = {1, 2, 3, 4, 5, 7, 8, 11, 12, 15, 16, 17, 18, 31, 40};
  static constexpr int32_t kSlopes_fx16[] = {65536, 32768, 65535, 21845, 4000, 0, 90000};
  spec::Random random(seed);
  BorderDrawing d;
  d.format = random.pick({SELVAGE_INDEX8, SELVAGE_RGB565, SELVAGE_RGBA8888});
  d.options = {SELVAGE_PROFILE_EXACT, SELVAGE_FILTER_NEAREST,
               random.percent(50) ? SELVAGE_ADDRESS_CLAMP : SELVAGE_ADDRESS_WRAP, 0, 0};
  if (d.format == SELVAGE_RGBA8888 && random.percent(50)) {
    d.options.filter = random.pick({SELVAGE_FILTER_FOUR, SELVAGE_FILTER_BILINEAR});
  }
  d.width_texel = random.pick(kSizes);
  d.height_texel = random.pick(kSizes);
  const auto slope = [&] { return random.pick(kSlopes_fx16) * random.pick({1, -1, 0}); };
  const int32_t across = slope(), down = slope();
  const int32_t u = (random.percent(50) ? d.width_texel : 0) * 65536 + random.in(-300000, 300000);
  const int32_t v = (random.percent(50) ? d.height_texel : 0) * 65536 + random.in(-300000, 300000);
  const int32_t least_q = side_px < 32 ? 256 : 1;  // the smaller, the gentler
  const int32_t q = least_q + (random.percent(50) ? 0 : random.in(1, 8));
  d.vertices = {{0, 0, u, v, least_q},
                {side_px * 256, 0, u + side_px * across, v + side_px * down, q},
                {0, side_px * 256, u - side_px * down, v + side_px * across, least_q}};
  return d;
}

// Three of the texture's corners, so that no texel is shown beyond it, but some at each end.
[[nodiscard]] BorderDrawing up_to_its_ends(uint64_t seed, int32_t side_px) {
  BorderDrawing d = about_a_corner(seed, side_px);
  spec::Random random(seed);
  const int32_t u_end = d.width_texel << 16, v_end = d.height_texel << 16;
  const int32_t corners[4][2] = {{0, 0}, {u_end, 0}, {u_end, v_end}, {0, v_end}};
  const int32_t first = random.in(0, 4), turn = random.percent(50) ? 1 : 3;
  for (int32_t i = 0; i < 3; ++i) {
    selvage_vertex& vertex = d.vertices[static_cast<size_t>(i)];
    vertex.u = corners[(first + i * turn) % 4][0];
    vertex.v = corners[(first + i * turn) % 4][1];
    vertex.x += random.in(-side_px, side_px) * 64;
    vertex.y += random.in(-side_px, side_px) * 64;
  }
  return d;
}

[[nodiscard]] ptrdiff_t bytes_of(selvage_format format) {
  return format == SELVAGE_RGBA8888 ? 4 : format == SELVAGE_RGB565 ? 2 : 1;
}

// The same by the call for many polygons, which draws small ones in another way.
[[nodiscard]] selvage_status drawn_by_many(const selvage_image& target, const BorderDrawing& d,
                                           const selvage_texture& texture) {
  const selvage_polygon polygon{d.vertices.data(), d.vertices.size(), &texture};
  const size_t bytes = selvage_draw_many_bytes(1);
  std::vector<std::max_align_t> scratch(bytes / sizeof(std::max_align_t) + 1);
  return selvage_draw_many(&target, nullptr, &polygon, 1, &d.options, 1, scratch.data(), bytes,
                           nullptr);
}

// Of some sizes: a small polygon may have all its texels in one window, two rows of a large one.
class TextureBoundsOf : public testing::TestWithParam<int32_t> {};

TEST_P(TextureBoundsOf, AreKeptByEveryKernel) {
  constexpr int32_t kWidths_px[] = {90, 9, 30, 70}, kHeight_px = 12;
  const int32_t times = 1 + GetParam() / 200;
  std::vector<uint32_t> row(static_cast<size_t>(times * kWidths_px[0] * kHeight_px));
  for (uint64_t seed = 1; seed <= 6000; ++seed) {
    SCOPED_TRACE(seed);
    BorderDrawing d =
        seed % 5 == 0 ? up_to_its_ends(seed, GetParam()) : about_a_corner(seed, GetParam());
    const ptrdiff_t pitch = d.width_texel * bytes_of(d.format);
    const auto bytes = static_cast<size_t>(pitch * d.height_texel);
    const FencedBytes texels(bytes,
                             seed % 2 == 0 ? FencedBytes::Side::kFirst : FencedBytes::Side::kLast);
    std::memset(texels.first(), 0x3C, bytes);
    const bool flipped = seed % 3 == 0;
    const selvage_texture texture{texels.first() + (flipped ? pitch * (d.height_texel - 1) : 0),
                                  d.width_texel,
                                  d.height_texel,
                                  flipped ? -pitch : pitch,
                                  d.format,
                                  SELVAGE_LAYOUT_ROWS,
                                  nullptr};
    const int32_t width_px = times * kWidths_px[seed % 4];
    const selvage_image target{row.data(), width_px, kHeight_px, width_px * bytes_of(d.format),
                               d.format};
    for (const selvage_kernel kernel : usable_kernels()) {
      d.options.kernel = kernel;
      ASSERT_EQ(selvage_draw(&target, nullptr, d.vertices.data(), d.vertices.size(), &texture,
                             &d.options),
                SELVAGE_OK);
      ASSERT_EQ(drawn_by_many(target, d, texture), SELVAGE_OK);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Side, TextureBoundsOf, testing::Values(12, 100, 400));

// Columns of less than a pixel, along which u and v run so fast that the pixels of a vector that
// are not there lie anywhere, which must be in the texture all the same.
TEST(TextureBounds, AreKeptWherePixelsAreNotThere) {
  constexpr int32_t kHeight_px = 20, kWidth_px = 20;
  std::vector<uint32_t> pixels(kWidth_px * kHeight_px);
  const selvage_image target{pixels.data(), kWidth_px, kHeight_px, kWidth_px * 4, SELVAGE_RGBA8888};
  for (uint64_t seed = 1; seed <= 1500; ++seed) {
    SCOPED_TRACE(seed);
    spec::Random random(seed);
    const int32_t width_texel = random.in(1, 12), height_texel = random.in(1, 12);
    const ptrdiff_t pitch = width_texel * 4;
    const auto bytes = static_cast<size_t>(pitch * height_texel);
    const FencedBytes texels(bytes,
                             seed % 2 == 0 ? FencedBytes::Side::kFirst : FencedBytes::Side::kLast);
    std::memset(texels.first(), 0x3C, bytes);
    const selvage_texture texture{texels.first(),   width_texel,         height_texel, pitch,
                                  SELVAGE_RGBA8888, SELVAGE_LAYOUT_ROWS, nullptr};
    const int32_t left = random.in(3, 10) * 256 + 128 - random.in(0, 64);
    const int32_t right = left + random.in(17, 200);
    const auto texel = [&] { return random.in(INT32_MIN / 2, INT32_MAX / 2) * random.in(0, 3); };
    const std::vector<selvage_vertex> sliver = {
        {left, 0, texel(), texel(), 1},
        {right, random.in(0, 256), texel(), texel(), 1},
        {left + random.in(0, 9), kHeight_px * 256, texel(), texel(), 1}};
    for (const selvage_kernel kernel : usable_kernels()) {
      for (const auto filter :
           {SELVAGE_FILTER_NEAREST, SELVAGE_FILTER_FOUR, SELVAGE_FILTER_BILINEAR}) {
        const selvage_options options{SELVAGE_PROFILE_EXACT, filter,
                                      seed % 4 < 3 ? SELVAGE_ADDRESS_WRAP : SELVAGE_ADDRESS_CLAMP,
                                      0, kernel};
        ASSERT_EQ(selvage_draw(&target, nullptr, sliver.data(), sliver.size(), &texture, &options),
                  SELVAGE_OK);
      }
    }
  }
}

}  // namespace
}  // namespace selvage::mapper
