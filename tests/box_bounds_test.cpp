// Boxes at the edges of a texture whose first or last byte lies at a page that may not be read.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <vector>

#include "mapper/box_row.h"
#include "mapper/channels.h"
#include "mapper/filter_box.h"
#include "mapper/layout.h"
#include "mapper/vector/kernel.h"
#include "spec/random.h"
#include "tests/fenced_bytes.h"
#include "tests/kernel_support.h"

namespace selvage::mapper {
namespace {

// Noise, without a byte behind the last row of texels or tiles.
struct FencedTexture {
  FencedTexture(selvage_layout layout, int32_t width, int32_t height, FencedBytes::Side side)
      : rows(rows_of_bytes(layout, SELVAGE_RGBA8888, width, height)),
        bytes(static_cast<size_t>(rows.row_bytes * rows.rows), side),
        texture{bytes.first(),    width,  height, static_cast<ptrdiff_t>(rows.row_bytes),
                SELVAGE_RGBA8888, layout, nullptr} {
    for (int32_t t = 0; t < height; ++t) {
      for (int32_t s = 0; s < width; ++s) {
        const uint32_t texel = static_cast<uint32_t>(s * 40503 + t * 7919) * 2654435761U;
        std::memcpy(bytes.first() + texel_offset(texture, s, t), &texel, sizeof texel);
      }
    }
  }

  RowsOfBytes rows;
  FencedBytes bytes;
  selvage_texture texture;
};

void expect_row_means(const BoxRow& boxes, int32_t count, const selvage_texture& texture) {
  std::vector<uint32_t> pixels(static_cast<size_t>(count));
  const selvage_image target{pixels.data(), count, 1, ptrdiff_t{4} * count, SELVAGE_RGBA8888};
  for (const selvage_address address : {SELVAGE_ADDRESS_CLAMP, SELVAGE_ADDRESS_WRAP}) {
    for (const selvage_kernel kernel : usable_kernels()) {
      const Kernels* const kernels = kernel == SELVAGE_KERNEL_SCALAR
                                         ? &scalar_kernels(SELVAGE_FILTER_AREA)
                                         : vector_kernels(kernel, SELVAGE_FILTER_AREA);
      kernels->draw_boxes(boxes, {0, 0, count}, {target, texture, address});
      for (int32_t i = 0; i < count; ++i) {
        ASSERT_EQ(pixels[static_cast<size_t>(i)], box_mean(texture, address, boxes.box(i)))
            << "kernel " << kernel << ", address " << address << ", pixel " << i << ", texture "
            << texture.width << " x " << texture.height;
      }
    }
  }
}

// A box that begins at, or ends at, the first or last texel, or a little before or behind it.
[[nodiscard]] int32_t point_at(spec::Random& random, int32_t side_fx8, int32_t size_texel) {
  const int32_t last_fx8 = 256 * size_texel - side_fx8;
  const int32_t begin_fx8 = random.pick({0, last_fx8}) + random.pick({0, 0, 1, -1, 255, -256, 300});
  return begin_fx8 + ((side_fx8 - 256) >> 1);
}

TEST(BoxBounds, AreKeptByEveryKernel) {
  spec::Random random(31);
  for (int i = 0; i < 400; ++i) {
    SCOPED_TRACE(i);
    const int32_t width = random.in(1, 36) + (i % 8 == 7 ? 150 : 0), height = random.in(1, 12);
    const auto layout = i % 2 == 0 ? SELVAGE_LAYOUT_ROWS : SELVAGE_LAYOUT_TILES;
    const FencedTexture fenced(layout, width, height,
                               i % 3 == 0 ? FencedBytes::Side::kFirst : FencedBytes::Side::kLast);
    BoxRow boxes;
    constexpr int32_t kBoxes = 12;
    for (int32_t k = 0; k < kBoxes; ++k) {
      const BoxSides sides{random.in(256, 256 * random.pick({2, 5, std::min(width, 36) + 1}) + 1),
                           random.in(256, 256 * random.pick({2, 5, height + 1}) + 1)};
      boxes.set(k, {point_at(random, sides.u_fx8, width), point_at(random, sides.v_fx8, height)},
                sides);
    }
    expect_row_means(boxes, kBoxes, fenced.texture);
    ASSERT_FALSE(HasFatalFailure());
  }
}

// So high that they are summed in parts, from the first row and to the last, or a row further.
TEST(BoxBounds, AreKeptByBoxesInParts) {
  constexpr int32_t kWidth = 12, kHeight = 300;
  for (const auto side : {FencedBytes::Side::kFirst, FencedBytes::Side::kLast}) {
    const FencedTexture fenced(SELVAGE_LAYOUT_ROWS, kWidth, kHeight, side);
    BoxRow boxes;
    int32_t count = 0;
    for (const int32_t height_fx8 : {32769, 33000, 40000, 65000, 65536, 256 * kHeight - 256}) {
      const int32_t last_fx8 = 256 * kHeight - height_fx8;
      for (const int32_t top_fx8 : {0, -1, -256, last_fx8, last_fx8 + 1, last_fx8 + 256}) {
        const BoxSides sides{count % 2 == 0 ? 256 : 700, height_fx8};
        boxes.set(count++, {1000, top_fx8 + ((height_fx8 - 256) >> 1)}, sides);
      }
    }
    expect_row_means(boxes, count, fenced.texture);
    ASSERT_FALSE(HasFatalFailure());
  }
}

// White, where sums are as great as they get: of one part and of several.
TEST(BoxBounds, HoldTheGreatestSums) {
  constexpr int32_t kWidth = 64, kHeight = 300;
  FencedTexture fenced(SELVAGE_LAYOUT_ROWS, kWidth, kHeight, FencedBytes::Side::kLast);
  std::memset(fenced.bytes.first(), 0xFF, static_cast<size_t>(fenced.rows.row_bytes) * kHeight);
  BoxRow boxes;
  int32_t count = 0;
  for (const int32_t width_fx8 : {256, 257, 300, 4096, 15360, 15361}) {
    const int32_t least_fx8 = (1 << 23) / width_fx8;
    for (const int32_t height_fx8 : {least_fx8, least_fx8 + 1, least_fx8 / 2 * 3, 2 * least_fx8}) {
      boxes.set(count++, {128 + width_fx8 / 2, 128 + height_fx8 / 2}, {width_fx8, height_fx8});
    }
  }
  expect_row_means(boxes, count, fenced.texture);
}

}  // namespace
}  // namespace selvage::mapper
