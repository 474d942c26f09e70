// Boxes by every kernel that this machine can run, against the mean of one box by integers, which
// filter_box_test.cpp holds against the specification.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <vector>

#include "mapper/box_row.h"
#include "mapper/filter_box.h"
#include "spec/random.h"
#include "tests/box_support.h"
#include "tests/kernel_support.h"

namespace selvage::mapper {
namespace {

constexpr int32_t kRowPx = 301;  // several pieces, the last of odd length

// A texture in rows, in tiles, or in rows with sums.
class Prepared {
 public:
  Prepared(const selvage_texture& source, selvage_layout layout, bool with_sums)
      : memory_(selvage_prepare_bytes(&source, layout, with_sums ? 1 : 0) +
                SELVAGE_PREPARED_ALIGNMENT) {
    void* aligned = memory_.data();
    size_t space = memory_.size();
    const size_t bytes = memory_.size() - SELVAGE_PREPARED_ALIGNMENT;
    EXPECT_NE(std::align(SELVAGE_PREPARED_ALIGNMENT, bytes, aligned, space), nullptr);
    EXPECT_EQ(selvage_prepare(&source, layout, with_sums ? 1 : 0, aligned, bytes, &texture_),
              SELVAGE_OK);
  }
  [[nodiscard]] const selvage_texture& texture() const { return texture_; }

 private:
  std::vector<std::byte> memory_;
  selvage_texture texture_{};
};

void expect_line_means(const BoxLine& line, int32_t count, const selvage_texture& texture) {
  for (const selvage_address address : {SELVAGE_ADDRESS_CLAMP, SELVAGE_ADDRESS_WRAP}) {
    for (const selvage_kernel kernel : usable_kernels()) {
      const std::vector<uint32_t> pixels = drawn_boxes(line, count, texture, address, kernel);
      for (int32_t i = 0; i < count; ++i) {
        ASSERT_EQ(pixels[static_cast<size_t>(i)], box_mean(texture, address, box_of(line, i)))
            << "kernel " << kernel << ", address " << address << ", pixel " << i << ", box "
            << line.sides.u_fx8 << " x " << line.sides.v_fx8 << ", texture " << texture.width
            << " x " << texture.height;
      }
    }
  }
}

// Whole texels and a little more or less, where the number of texels changes.
[[nodiscard]] int32_t any_side_up_to(spec::Random& random, int32_t most_texels) {
  const int32_t whole = 256 * random.in(1, most_texels + 1);
  const int32_t side = random.pick(
      {whole, whole + 1, whole + 2, whole + 255, random.in(256, 256 * most_texels + 1)});
  return side;
}

TEST(BoxPieces, FollowEachOtherAndAreNoLongerThanTheirRoom) {
  for (const int32_t width_px : {1, 127, 128, 129, 255, 256, 257, 1000}) {
    const Span span{5, -70, -70 + width_px};
    int32_t next_px = span.left_px;
    for_each_box_piece(span, [&](const Span& piece) {
      EXPECT_FALSE(piece.empty());
      EXPECT_EQ(piece.row, span.row);
      EXPECT_EQ(piece.left_px, next_px);
      EXPECT_EQ(piece.width_px(), std::min(kBoxPiece_px, span.right_px - next_px));
      next_px = piece.right_px;
    });
    EXPECT_EQ(next_px, span.right_px);
  }
}

// Textures about as wide as the windows that columns are summed in, and boxes that leave them.
TEST(BoxKernel, IsExactForEverySizeAndPlace) {
  spec::Random random(5);
  for (int i = 0; i < 600; ++i) {
    const int32_t width = random.in(1, 40), height = random.in(1, 40);
    const std::vector<uint32_t> texels = noise_texels(random, width * height);
    const selvage_layout layout = random.pick({SELVAGE_LAYOUT_ROWS, SELVAGE_LAYOUT_TILES});
    const Prepared prepared(in_rows(texels, width), layout, random.percent(30));
    const int32_t most = random.pick({1, 2, 9, 20});
    const BoxLine line{
        {random.in(-256 * width, 256 * width), random.in(-256 * height, 256 * height)},
        {random.in(-300, 300), random.in(-300, 300)},
        {any_side_up_to(random, most), any_side_up_to(random, most)}};
    expect_line_means(line, random.pick({1, 7, 16, 40}), prepared.texture());
    ASSERT_FALSE(HasFatalFailure()) << i;
  }
}

// Every place of a box of each size within a texel, at the texture's edges and inside.
TEST(BoxKernel, IsExactForEveryPartOfATexel) {
  spec::Random random(6);
  const std::vector<uint32_t> texels = noise_texels(random, 24 * 24);
  for (const int32_t side : {256, 257, 511, 512, 513, 1337, 2048, 2049}) {
    for (const int32_t begin : {-side, -700, 0, 1500, 24 * 256 - side, 24 * 256 - 100}) {
      expect_line_means({{begin, begin + 77}, {1, -1}, {side, side + 3}}, kRowPx,
                        in_rows(texels, 24));
      ASSERT_FALSE(HasFatalFailure());
    }
  }
}

// The longest sides that vectors take, the largest area, and what is longer or larger by the least.
TEST(BoxKernel, IsExactAboutTheLimitsOfItsNumbers) {
  const std::vector<uint32_t> white(300 * 300, 0xFFFFFFFF);
  spec::Random random(7);
  const std::vector<uint32_t> mixed = noise_texels(random, 300 * 300);
  for (const BoxSides sides :
       {BoxSides{32767, 256}, BoxSides{32768, 256}, BoxSides{256, 32767}, BoxSides{256, 32768},
        BoxSides{2896, 2896}, BoxSides{2897, 2896}, BoxSides{4096, 2048}, BoxSides{2048, 4096},
        BoxSides{4096, 2049}, BoxSides{32767, 32767}, BoxSides{1 << 17, 300}}) {
    for (const auto* const texels : {&white, &mixed}) {
      for (const int32_t begin : {-9000, 0, 20000, 60000}) {
        expect_line_means({{begin, begin}, {97, 61}, sides}, 20, in_rows(*texels, 300));
        ASSERT_FALSE(HasFatalFailure());
      }
    }
  }
}

// Boxes that vectors sum in parts: of whichever height, and up to the width that is no more.
TEST(BoxKernel, IsExactInParts) {
  constexpr int32_t kWidth = 130, kHeight = 700;
  spec::Random random(9);
  const std::vector<uint32_t> white(kWidth * kHeight, 0xFFFFFFFF);
  const std::vector<uint32_t> mixed = noise_texels(random, kWidth * kHeight);
  for (int i = 0; i < 200; ++i) {
    const int32_t width = random.pick({60 * 256, 60 * 256 + 1, any_side_up_to(random, 64)});
    const int32_t least = (1 << 23) / width;
    const int32_t height = random.pick({least, least + 1, 2 * least, random.in(least, 256 * 650)});
    const int32_t down = 256 * kHeight - height;
    const BoxLine line{{random.in(0, 256 * (kWidth - 64)) + width / 2,
                        random.pick({0, down, random.in(-300, down + 300)}) + height / 2},
                       {97, 61},
                       {width, height}};
    expect_line_means(line, 5, in_rows(i % 2 == 0 ? white : mixed, kWidth));
    ASSERT_FALSE(HasFatalFailure()) << i;
  }
}

// Coordinates reach 2^15 texels either way.
TEST(BoxKernel, IsExactInTheLargestTextures) {
  constexpr int32_t kLong = 32767;
  spec::Random random(8);
  const std::vector<uint32_t> texels = noise_texels(random, kLong * 12);
  for (const int32_t begin : {-(1 << 23) - 300, -4000, (1 << 23) - 30000, (1 << 23) - 2000}) {
    const BoxSides sides{1337, 1100};
    expect_line_means({{begin, 700}, {400, 3}, sides}, 40, in_rows(texels, kLong));
    expect_line_means({{700, begin}, {3, 400}, sides}, 40, in_rows(texels, 12));
    ASSERT_FALSE(HasFatalFailure());
  }
}

// Texels of four quarters, so that a box about their corner has a mean of 254.5, or less by as
// little as can be: 1 / (2 area).
TEST(BoxKernel, RoundsHalvesUpAndWhatIsBarelyBelowDown) {
  constexpr int32_t kSide = 24, kMiddle_fx8 = kSide / 2 * 256;
  std::vector<uint32_t> texels;
  for (int32_t t = 0; t < kSide; ++t) {
    for (int32_t s = 0; s < kSide; ++s) {
      texels.push_back((s < kSide / 2) == (t < kSide / 2) ? 0x01FEFE00 : 0x02FFFF01);
    }
  }
  const selvage_texture texture = in_rows(texels, kSide);
  for (int32_t side = 256; side <= 2896; ++side) {
    const int32_t begin = kMiddle_fx8 - (side + 1) / 2 + ((side - 256) >> 1);
    const BoxLine line{{begin, begin}, {}, {side, side}};
    ASSERT_EQ(box_of(line, 0).left_fx8, kMiddle_fx8 - (side + 1) / 2);
    for (const selvage_kernel kernel : usable_kernels()) {
      ASSERT_EQ(drawn_boxes(line, 1, texture, SELVAGE_ADDRESS_CLAMP, kernel)[0],
                side % 2 == 0 ? 0x02FFFF01U : 0x01FEFE00U)
          << "kernel " << kernel << ", side " << side;
    }
  }
}

// Textures so long that 1/256 texels of them are no 32-bit number, and as wide as a box's windows.
// Of their texels those about the seam between two copies are written, the others are as they come.
TEST(BoxKernel, IsExactInTexturesLongerThanCoordinatesReach) {
  constexpr int32_t kShort = 8, kWritten = 2000, kSeam_fx8 = -120000;
  spec::Random random(12);
  const std::vector<uint32_t> noise = noise_texels(random, kWritten * kShort);
  for (const int32_t length : {8388607, 8388608, 16777716}) {
    const size_t all = static_cast<size_t>(length) * kShort;
    const auto texels = std::make_unique_for_overwrite<uint32_t[]>(all);
    for (const bool is_row : {true, false}) {
      for (int32_t i = 0; i < kWritten * kShort; ++i) {
        const int32_t along = i / kShort, at = along < kWritten / 2 ? along : length - along + 999;
        const int32_t s = is_row ? at : i % kShort, t = is_row ? i % kShort : at;
        texels[static_cast<size_t>(t) * static_cast<size_t>(is_row ? length : kShort) +
               static_cast<size_t>(s)] = noise[static_cast<size_t>(i)];
      }
      const int32_t width = is_row ? length : kShort, height = is_row ? kShort : length;
      const selvage_texture texture{
          texels.get(),        width,  height, ptrdiff_t{4} * width, SELVAGE_RGBA8888,
          SELVAGE_LAYOUT_ROWS, nullptr};
      for (const int32_t side : {300, 5000, 51200}) {
        const BoxSides sides{is_row ? side : 300, is_row ? 300 : side};
        const FilterPoint start{is_row ? kSeam_fx8 : 700, is_row ? 700 : kSeam_fx8};
        expect_line_means({start, {is_row ? 6000 : 0, is_row ? 0 : 6000}, sides}, 40, texture);
        ASSERT_FALSE(HasFatalFailure()) << length << ", side " << side;
      }
    }
  }
}

}  // namespace
}  // namespace selvage::mapper
