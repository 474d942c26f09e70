// selvage_prepare: where it puts texels and sums, and what it refuses.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <new>
#include <vector>

#include "mapper/image_check.h"
#include "mapper/layout.h"
#include "mapper/prepare.h"
#include "mapper/sums.h"
#include "spec/canvas.h"
#include "spec/random.h"

namespace selvage::mapper {
namespace {

// Memory that is aligned, and filled with a byte that is no texel.
class Memory64 {
 public:
  explicit Memory64(size_t bytes) : storage_(bytes + 2 * kAlignment, kFill) {}
  [[nodiscard]] char* data() {
    const auto begin = reinterpret_cast<uintptr_t>(storage_.data());
    return storage_.data() + (kAlignment - begin % kAlignment);
  }
  static constexpr char kFill = 0x6B;

 private:
  static constexpr size_t kAlignment = SELVAGE_PREPARED_ALIGNMENT;
  std::vector<char> storage_;
};

[[nodiscard]] spec::Canvas random_texels(spec::Random& random, selvage_format format, int32_t width,
                                         int32_t height) {
  spec::Canvas canvas(format, width, height, random.in(0, 5), random.percent(50), 0xEE);
  for (int32_t t = 0; t < height; ++t) {
    for (int32_t s = 0; s < width; ++s) {
      canvas.set_pixel(s, t, static_cast<uint32_t>(random.bits()));
    }
  }
  return canvas;
}

[[nodiscard]] uint32_t value_at(const char* at, selvage_format format) {
  uint32_t value = 0;
  std::memcpy(&value, at, static_cast<size_t>(bytes_per_pixel(format)));
  return value;
}

// The interface's own words about tiles.
[[nodiscard]] ptrdiff_t stated_offset(const selvage_texture& texture, int32_t s, int32_t t) {
  const ptrdiff_t texel = bytes_per_pixel(texture.format);
  if (texture.layout == SELVAGE_LAYOUT_ROWS) return t * texture.pitch + s * texel;
  const ptrdiff_t tile = t / 4 * texture.pitch + s / 4 * 16 * texel;
  return tile + (t % 4 * 4 + s % 4) * texel;
}

TEST(Prepare, PutsEveryTexelWhereTheLayoutSays) {
  spec::Random random(1);
  for (int i = 0; i < 600; ++i) {
    const selvage_format format = random.pick({SELVAGE_INDEX8, SELVAGE_RGB565, SELVAGE_RGBA8888});
    const int32_t width = random.in(1, 40), height = random.in(1, 20);
    const spec::Canvas texels = random_texels(random, format, width, height);
    const selvage_texture source = texels.texture();
    for (const selvage_layout layout : {SELVAGE_LAYOUT_ROWS, SELVAGE_LAYOUT_TILES}) {
      const size_t bytes = selvage_prepare_bytes(&source, layout, 0);
      Memory64 memory(bytes), again_memory(4 * bytes + 4096);
      selvage_texture prepared{}, again{};
      ASSERT_EQ(selvage_prepare(&source, layout, 0, memory.data(), bytes, &prepared), SELVAGE_OK);
      ASSERT_EQ(check_texture(&prepared), SELVAGE_OK);
      EXPECT_EQ(prepared.prepared, nullptr);
      std::vector<bool> is_texel(bytes);
      for (int32_t t = 0; t < height; ++t) {
        for (int32_t s = 0; s < width; ++s) {
          const ptrdiff_t at = stated_offset(prepared, s, t);
          ASSERT_EQ(at, texel_offset(prepared, s, t));
          ASSERT_EQ(value_at(memory.data() + at, format), texels.pixel(s, t));
          for (ptrdiff_t k = 0; k < bytes_per_pixel(format); ++k) {
            is_texel.at(static_cast<size_t>(at + k)) = true;
          }
        }
      }
      for (size_t k = 0; k < bytes; ++k) {
        ASSERT_TRUE(is_texel[k] || memory.data()[k] == Memory64::kFill) << "between texels";
      }
      ASSERT_EQ(memory.data()[bytes], Memory64::kFill) << "beyond the memory";
      // From any layout to any other; the descriptor may be the source's.
      again = prepared;
      const selvage_layout other = layout == SELVAGE_LAYOUT_ROWS ? SELVAGE_LAYOUT_TILES : layout;
      ASSERT_EQ(selvage_prepare(&again, other, 0, again_memory.data(), 4 * bytes + 4096, &again),
                SELVAGE_OK);
      const ptrdiff_t last = stated_offset(again, width - 1, height - 1);
      EXPECT_EQ(value_at(again_memory.data() + last, format), texels.pixel(width - 1, height - 1));
    }
  }
}

// The texels of a column fall into all sets of a cache of 64-byte lines, 2^k of them.
TEST(Prepare, ChoosesAPitchOfAnOddNumberOfCacheLines) {
  for (const int64_t row : {1, 64, 65, 128, 8000, 8192, 65536, 1 << 20}) {
    const int64_t pitch = padded_pitch(row);
    EXPECT_GE(pitch, row);
    EXPECT_LE(pitch, row + 127);
    EXPECT_EQ(pitch % 128, 64);
  }
}

TEST(Prepare, SumsUpEveryRectangleFromTheCorner) {
  spec::Random random(2);
  for (int i = 0; i < 100; ++i) {
    const int32_t width = random.in(1, 9), height = random.in(1, 9);
    const spec::Canvas texels = random_texels(random, SELVAGE_RGBA8888, width, height);
    const selvage_texture source = texels.texture();
    const selvage_layout layout = random.pick({SELVAGE_LAYOUT_ROWS, SELVAGE_LAYOUT_TILES});
    const size_t bytes = selvage_prepare_bytes(&source, layout, 1);
    ASSERT_EQ(bytes % SELVAGE_PREPARED_ALIGNMENT, 0U);
    ASSERT_EQ(selvage_prepare_bytes(&source, layout, 0) % SELVAGE_PREPARED_ALIGNMENT, 0U);
    Memory64 memory(bytes);
    selvage_texture prepared{};
    ASSERT_EQ(selvage_prepare(&source, layout, 1, memory.data(), bytes, &prepared), SELVAGE_OK);
    ASSERT_EQ(check_texture(&prepared), SELVAGE_OK);
    ASSERT_EQ(prepared.prepared, place_of_sums(prepared));
    const Sums sums(prepared);
    for (int32_t t = 0; t <= height; ++t) {
      for (int32_t s = 0; s <= width; ++s) {
        ChannelSums wanted{};
        for (int32_t y = 0; y < t; ++y) {
          for (int32_t x = 0; x < s; ++x) {
            for (size_t k = 0; k < 4; ++k) wanted[k] += texels.pixel(x, y) >> (8 * k) & 255;
          }
        }
        ASSERT_EQ(sums.at(s, t), wanted);
      }
    }
  }
}

// Of 3 texels, a row of sums fills its pitch.
TEST(Prepare, WritesNothingBehindTheSums) {
  for (const int32_t width : {1, 2, 3, 4, 11}) {
    spec::Random random(3);
    const spec::Canvas texels = random_texels(random, SELVAGE_RGBA8888, width, 5);
    const selvage_texture source = texels.texture();
    const size_t bytes = selvage_prepare_bytes(&source, SELVAGE_LAYOUT_ROWS, 1);
    Memory64 memory(bytes);
    selvage_texture prepared{};
    ASSERT_EQ(selvage_prepare(&source, SELVAGE_LAYOUT_ROWS, 1, memory.data(), bytes, &prepared),
              SELVAGE_OK);
    for (size_t i = 0; i < 32; ++i) ASSERT_EQ(memory.data()[bytes + i], Memory64::kFill) << width;
  }
}

class PrepareRefuses : public testing::Test {
 protected:
  // Whatever was spoiled: nothing is written, the descriptor neither.
  [[nodiscard]] selvage_status call() {
    const std::vector<char> before(memory_.data(), memory_.data() + kBytes);
    selvage_texture prepared{};
    prepared.width = -7;
    const selvage_status status = selvage_prepare(source_pointer, layout, with_sums, memory, bytes,
                                                  prepared_pointer != nullptr ? prepared_pointer
                                                  : no_prepared               ? nullptr
                                                                              : &prepared);
    EXPECT_TRUE(status == SELVAGE_OK || prepared.width == -7);
    EXPECT_TRUE(status == SELVAGE_OK || std::equal(before.begin(), before.end(), memory_.data()));
    return status;
  }

  static constexpr size_t kBytes = 4096;
  Memory64 memory_{kBytes};
  std::array<uint32_t, 15> texels_{};
  selvage_texture source{texels_.data(), 5, 3, 20, SELVAGE_RGBA8888, SELVAGE_LAYOUT_ROWS, nullptr};
  const selvage_texture* source_pointer = &source;
  selvage_layout layout = SELVAGE_LAYOUT_TILES;
  int32_t with_sums = 0;
  void* memory = memory_.data();
  size_t bytes = kBytes;
  bool no_prepared = false;
  selvage_texture* prepared_pointer = nullptr;
};

TEST_F(PrepareRefuses, WhatNoDrawingTakes) {
  source.width = 0;
  EXPECT_EQ(call(), SELVAGE_ERROR_TEXTURE_SIZE);
  EXPECT_EQ(selvage_prepare_bytes(&source, layout, 0), SIZE_MAX);
  source_pointer = nullptr;
  EXPECT_EQ(call(), SELVAGE_ERROR_TEXTURE_NULL);
  EXPECT_EQ(selvage_prepare_bytes(nullptr, layout, 0), SIZE_MAX);
}

TEST_F(PrepareRefuses, UnknownLayouts) {
  for (const selvage_layout unknown : {-1, 2, INT32_MIN, INT32_MAX}) {
    layout = unknown;
    EXPECT_EQ(call(), SELVAGE_ERROR_PREPARE_LAYOUT);
    EXPECT_EQ(selvage_prepare_bytes(&source, layout, 0), SIZE_MAX);
  }
}

TEST_F(PrepareRefuses, SumsOfWhatHasNoChannels) {
  source.format = SELVAGE_RGB565;
  with_sums = -1;
  EXPECT_EQ(call(), SELVAGE_ERROR_PREPARE_SUMS);
  EXPECT_EQ(selvage_prepare_bytes(&source, layout, 1), SIZE_MAX);
  with_sums = 0;
  EXPECT_EQ(call(), SELVAGE_OK);
}

TEST_F(PrepareRefuses, NoMemoryAndNoPlaceForTheResult) {
  memory = nullptr;
  EXPECT_EQ(call(), SELVAGE_ERROR_PREPARE_NULL);
  memory = memory_.data();
  no_prepared = true;
  EXPECT_EQ(call(), SELVAGE_ERROR_PREPARE_NULL);
}

TEST_F(PrepareRefuses, MisalignedMemory) {
  for (const ptrdiff_t off : {1, 4, 16, 32, 63}) {
    memory = memory_.data() + off;
    EXPECT_EQ(call(), SELVAGE_ERROR_PREPARE_ALIGNMENT);
  }
}

TEST_F(PrepareRefuses, TooLittleMemory) {
  for (const int32_t sums : {0, 1}) {
    with_sums = sums;
    bytes = selvage_prepare_bytes(&source, layout, sums) - 1;
    EXPECT_EQ(call(), SELVAGE_ERROR_PREPARE_SIZE);
    ++bytes;
    EXPECT_EQ(call(), SELVAGE_OK);
  }
}

TEST_F(PrepareRefuses, MoreThanAddressesCanTell) {
  source.width = INT32_MAX / 8;
  source.pitch = ptrdiff_t{4} * source.width;
  source.height = static_cast<int32_t>(std::min<ptrdiff_t>(PTRDIFF_MAX / source.pitch, INT32_MAX));
  with_sums = 1;
  bytes = SIZE_MAX;
  EXPECT_EQ(selvage_prepare_bytes(&source, layout, 1), SIZE_MAX);
  EXPECT_EQ(call(), SELVAGE_ERROR_PREPARE_SIZE);
}

TEST_F(PrepareRefuses, MemoryThatHoldsTheSource) {
  source.texels = memory_.data() + 64;
  EXPECT_EQ(call(), SELVAGE_ERROR_PREPARE_OVERLAP);
  source.texels = texels_.data();
  const size_t needed = selvage_prepare_bytes(&source, layout, 0);
  source.texels = memory_.data() + needed;
  EXPECT_EQ(call(), SELVAGE_OK);
  source.texels = memory_.data() + needed - 4;
  EXPECT_EQ(call(), SELVAGE_ERROR_PREPARE_OVERLAP);
}

TEST_F(PrepareRefuses, MemoryThatHoldsADescriptor) {
  source_pointer = new (memory_.data()) selvage_texture(source);
  EXPECT_EQ(call(), SELVAGE_ERROR_PREPARE_OVERLAP);
  source_pointer = &source;
  prepared_pointer = reinterpret_cast<selvage_texture*>(memory_.data() + 64);
  EXPECT_EQ(call(), SELVAGE_ERROR_PREPARE_OVERLAP);
}

// Texels alone may end where memory does; sums behind them would not.
TEST(PreparedMemory, EndsBeforeAddressesDo) {
  const uint32_t texel = 0;
  constexpr int32_t kHeight = 3;
  selvage_texture texture{&texel, 1, kHeight, 64, SELVAGE_RGBA8888, SELVAGE_LAYOUT_ROWS, nullptr};
  EXPECT_NE(place_of_sums(texture), nullptr);
  texture.pitch = PTRDIFF_MAX / kHeight;
  EXPECT_EQ(place_of_sums(texture), nullptr);
  texture.pitch = -64;  // sums lie behind the last row
  EXPECT_EQ(place_of_sums(texture), nullptr);
  texture.pitch = 64;
  texture.format = SELVAGE_INDEX8;  // and are of four channels
  EXPECT_EQ(place_of_sums(texture), nullptr);
}

// What a target may not meet: the tiles to the end of the last row of them, and the sums behind.
TEST(PreparedMemory, LiesApartFromTheTarget) {
  alignas(64) static std::array<char, 16384> block{};
  const selvage_texture tiles{block.data(),         5,      5, 192, SELVAGE_RGBA8888,
                              SELVAGE_LAYOUT_TILES, nullptr};
  const auto target_at = [&](ptrdiff_t offset) {
    return selvage_image{block.data() + offset, 4, 4, 16, SELVAGE_RGBA8888};
  };
  EXPECT_EQ(check_texture(&tiles), SELVAGE_OK);
  EXPECT_EQ(check_pair(target_at(192 + 2 * 64 - 4), tiles), SELVAGE_ERROR_OVERLAP);
  EXPECT_EQ(check_pair(target_at(192 + 2 * 64), tiles), SELVAGE_OK);
  selvage_texture summed = tiles;
  summed.prepared = place_of_sums(tiles);
  ASSERT_EQ(summed.prepared, block.data() + 2 * 192);
  EXPECT_EQ(check_texture(&summed), SELVAGE_OK);
  const ptrdiff_t end = 2 * 192 + 6 * padded_pitch(6 * 16);
  EXPECT_EQ(check_pair(target_at(end - 4), summed), SELVAGE_ERROR_OVERLAP);
  EXPECT_EQ(check_pair(target_at(end), summed), SELVAGE_OK);
  EXPECT_EQ(check_pair(target_at(2 * 192), summed), SELVAGE_ERROR_OVERLAP);
  EXPECT_EQ(check_pair(target_at(192 + 2 * 64), summed), SELVAGE_OK);  // between texels and sums
  EXPECT_EQ(check_pair(target_at(end - 4), tiles), SELVAGE_OK);
}

}  // namespace
}  // namespace selvage::mapper
