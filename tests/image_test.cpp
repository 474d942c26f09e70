#include "mapper/image_check.h"

#include <gtest/gtest.h>

#include <array>
#include <limits>

namespace selvage::mapper {
namespace {

alignas(4) std::array<char, 4096> pixel_memory;

[[nodiscard]] selvage_image image(ptrdiff_t offset, int32_t width, int32_t height, ptrdiff_t pitch,
                                  selvage_format format = SELVAGE_RGBA8888) {
  return {pixel_memory.data() + offset, width, height, pitch, format};
}

[[nodiscard]] selvage_texture texture(ptrdiff_t offset, int32_t width, int32_t height,
                                      ptrdiff_t pitch, selvage_format format = SELVAGE_RGBA8888) {
  return {pixel_memory.data() + offset, width, height, pitch, format, SELVAGE_LAYOUT_ROWS, nullptr};
}

[[nodiscard]] selvage_status target_status(const selvage_image& target) {
  return check_target(&target);
}

TEST(Image, AcceptsWhatTheHeaderAllows) {
  EXPECT_EQ(target_status(image(0, 4, 4, 16)), SELVAGE_OK);
  EXPECT_EQ(target_status(image(64, 4, 4, -16)), SELVAGE_OK);
  EXPECT_EQ(target_status(image(1, 3, 4, 3, SELVAGE_INDEX8)), SELVAGE_OK);
  EXPECT_EQ(target_status(image(2, 3, 4, 6, SELVAGE_RGB565)), SELVAGE_OK);
  const ptrdiff_t most = std::numeric_limits<ptrdiff_t>::max();
  EXPECT_EQ(target_status(image(0, 1, 1, most, SELVAGE_INDEX8)), SELVAGE_OK);
  EXPECT_EQ(target_status(image(0, 1, 2, most - 1, SELVAGE_INDEX8)), SELVAGE_OK);
  EXPECT_EQ(target_status(image(0, 1, 2, most, SELVAGE_INDEX8)), SELVAGE_ERROR_TARGET_PITCH);
}

TEST(Image, NamesWhatIsWrong) {
  EXPECT_EQ(check_target(nullptr), SELVAGE_ERROR_TARGET_NULL);
  EXPECT_EQ(target_status({nullptr, 4, 4, 16, SELVAGE_RGBA8888}), SELVAGE_ERROR_TARGET_NULL);
  EXPECT_EQ(target_status(image(0, 4, 4, 16, 3)), SELVAGE_ERROR_TARGET_FORMAT);
  EXPECT_EQ(target_status(image(0, 0, 4, 16)), SELVAGE_ERROR_TARGET_SIZE);
  EXPECT_EQ(target_status(image(0, 4, -1, 16)), SELVAGE_ERROR_TARGET_SIZE);
  EXPECT_EQ(target_status(image(0, 4, 4, 12)), SELVAGE_ERROR_TARGET_PITCH);
  EXPECT_EQ(target_status(image(0, 4, 4, 18)), SELVAGE_ERROR_TARGET_PITCH);
  EXPECT_EQ(target_status(image(2, 4, 4, 16)), SELVAGE_ERROR_TARGET_ALIGNMENT);
  EXPECT_EQ(target_status(image(1, 3, 4, 6, SELVAGE_RGB565)), SELVAGE_ERROR_TARGET_ALIGNMENT);
}

TEST(Pair, RefusesOverlapAndMismatch) {
  const selvage_image target = image(0, 4, 4, 16);  // bytes [0, 64)
  EXPECT_EQ(check_pair(target, texture(64, 4, 4, 16)), SELVAGE_OK);
  EXPECT_EQ(check_pair(target, texture(60, 4, 4, 16)), SELVAGE_ERROR_OVERLAP);
  EXPECT_EQ(check_pair(image(64, 4, 4, 16), texture(0, 4, 4, 16)), SELVAGE_OK);
  EXPECT_EQ(check_pair(image(60, 4, 4, 16), texture(0, 4, 4, 16)), SELVAGE_ERROR_OVERLAP);
  EXPECT_EQ(check_pair(target, texture(112, 4, 4, -16)), SELVAGE_OK);
  EXPECT_EQ(check_pair(target, texture(108, 4, 4, -16)), SELVAGE_ERROR_OVERLAP);
  EXPECT_EQ(check_pair(target, texture(64, 4, 4, 4, SELVAGE_INDEX8)),
            SELVAGE_ERROR_FORMAT_MISMATCH);
}

// Two rectangles of one bitmap of 16 pixels a row.
TEST(Pair, LetsTwoPartsOfAnAtlasInterleave) {
  const selvage_image left = image(0, 8, 8, 64);
  EXPECT_EQ(check_pair(left, texture(32, 8, 8, 64)), SELVAGE_OK);
  EXPECT_EQ(check_pair(left, texture(28, 8, 8, 64)), SELVAGE_ERROR_OVERLAP);
  EXPECT_EQ(check_pair(left, texture(36, 8, 8, 64)), SELVAGE_ERROR_OVERLAP);
  EXPECT_EQ(check_pair(left, texture(32 + 7 * 64, 8, 8, -64)), SELVAGE_OK);
  EXPECT_EQ(check_pair(left, texture(32, 8, 8, 32)), SELVAGE_ERROR_OVERLAP);
  EXPECT_EQ(check_pair(image(32, 8, 8, 64), texture(0, 8, 8, 64)), SELVAGE_OK);
}

TEST(Vertices, MustLieApartFromTheTarget) {
  const selvage_image target = image(0, 4, 4, 16);
  const auto at = [](size_t offset) {
    return reinterpret_cast<const selvage_vertex*>(pixel_memory.data() + offset);
  };
  EXPECT_EQ(check_vertices(memory_of(target), at(64), 3), SELVAGE_OK);
  EXPECT_EQ(check_vertices(memory_of(target), at(60), 3), SELVAGE_ERROR_OVERLAP);
  EXPECT_EQ(check_vertices(memory_of(target), at(64), 2), SELVAGE_ERROR_VERTEX_COUNT);
  EXPECT_EQ(check_vertices(memory_of(target), nullptr, 3), SELVAGE_ERROR_VERTICES_NULL);
  // More vertices than memory: they would run into any target behind them.
  EXPECT_EQ(check_vertices(memory_of(image(64, 4, 4, 16)), at(0), SIZE_MAX), SELVAGE_ERROR_OVERLAP);
  EXPECT_EQ(check_vertices(memory_of(image(64, 4, 4, 16)), at(4), 3), SELVAGE_OK);
  EXPECT_EQ(check_vertices(memory_of(image(64, 4, 4, 16)), at(8), 3), SELVAGE_ERROR_OVERLAP);
}

TEST(Clip, IsCutToTheTarget) {
  const selvage_image target = image(0, 4, 3, 16);
  const auto same = [](selvage_rect a, selvage_rect b) {
    return a.left == b.left && a.top == b.top && a.right == b.right && a.bottom == b.bottom;
  };
  EXPECT_TRUE(same(visible_rect(target, nullptr), {0, 0, 4, 3}));
  const selvage_rect beyond{-5, -5, 99, 99}, inside{1, 1, 2, 2};
  const selvage_rect endless{INT32_MIN, INT32_MIN, INT32_MAX, INT32_MAX};
  const selvage_rect nowhere{INT32_MAX, INT32_MAX, INT32_MIN, INT32_MIN};
  EXPECT_TRUE(same(visible_rect(target, &endless), {0, 0, 4, 3}));
  EXPECT_GT(visible_rect(target, &nowhere).left, visible_rect(target, &nowhere).right);
  EXPECT_GT(visible_rect(target, &nowhere).top, visible_rect(target, &nowhere).bottom);
  EXPECT_TRUE(same(visible_rect(target, &beyond), {0, 0, 4, 3}));
  EXPECT_TRUE(same(visible_rect(target, &inside), inside));
}

// One column of bytes that runs upwards: its memory begins pitch by pitch before its first row.
TEST(Image, OfOneColumnUpwardsBeginsAtItsLastRow) {
  const selvage_image upwards = image(100, 1, 8, -1, SELVAGE_INDEX8);
  EXPECT_EQ(target_status(upwards), SELVAGE_OK);
  EXPECT_EQ(memory_of(upwards).begin, reinterpret_cast<uintptr_t>(pixel_memory.data()) + 93);
  EXPECT_EQ(memory_of(upwards).end, reinterpret_cast<uintptr_t>(pixel_memory.data()) + 101);
  EXPECT_EQ(check_pair(upwards, texture(94, 1, 1, 1, SELVAGE_INDEX8)), SELVAGE_ERROR_OVERLAP);
}

// As many values as no memory holds: up to its end, and not around it.
TEST(Image, OfTooManyValuesEndsWithTheMemory) {
  const auto begin = reinterpret_cast<uintptr_t>(pixel_memory.data());
  EXPECT_EQ(memory_of(pixel_memory.data(), SIZE_MAX, 1).end, UINTPTR_MAX);
  EXPECT_EQ(memory_of(pixel_memory.data(), SIZE_MAX, 20).end, UINTPTR_MAX);
  EXPECT_EQ(memory_of(pixel_memory.data(), (UINTPTR_MAX - begin) / 20 + 1, 20).end, UINTPTR_MAX);
  EXPECT_EQ(memory_of(pixel_memory.data(), (UINTPTR_MAX - begin) / 20, 20).end,
            begin + (UINTPTR_MAX - begin) / 20 * 20);
  EXPECT_EQ(memory_of(pixel_memory.data(), 7, 20).end, begin + 140);
}

TEST(Image, UpToTheLastAddressMeetsWhatLiesThere) {
  const auto* const last_page = reinterpret_cast<const char*>(UINTPTR_MAX - 4095);
  const Memory rows = memory_of_rows(last_page, {128, 32}, 128), below{0, UINTPTR_MAX - 4095};
  EXPECT_TRUE(rows.meets(memory_of_rows(last_page + 2048, {128, 16}, 128)));
  EXPECT_TRUE(rows.meets(memory_of(last_page, 1, 1)));
  EXPECT_FALSE(rows.meets(below));
}

// 2^32 bytes: as many as none where addresses have 32 bits.
TEST(Image, WithRowsLongerThanThePitchIsRefused) {
  static uint32_t pixel;
  constexpr int32_t kWidth_px = 1 << 30;
  const selvage_image target{&pixel, kWidth_px, 1, 4, SELVAGE_RGBA8888};
  const selvage_texture texture{&pixel,           kWidth_px,           1,      4,
                                SELVAGE_RGBA8888, SELVAGE_LAYOUT_ROWS, nullptr};
  EXPECT_EQ(check_target(&target), SELVAGE_ERROR_TARGET_PITCH);
  EXPECT_EQ(check_texture(&texture), SELVAGE_ERROR_TEXTURE_PITCH);
}

TEST(Image, IsInTilesAsManyAsHoldIt) {
  for (int32_t texels = 1; texels <= 13; ++texels) {
    const int64_t tiles = texels <= 4 ? 1 : texels <= 8 ? 2 : texels <= 12 ? 3 : 4;
    const RowsOfBytes size =
        rows_of_bytes(SELVAGE_LAYOUT_TILES, SELVAGE_RGBA8888, texels, 14 - texels);
    EXPECT_EQ(size.row_bytes, tiles * 64) << texels;
    const RowsOfBytes turned =
        rows_of_bytes(SELVAGE_LAYOUT_TILES, SELVAGE_RGBA8888, 14 - texels, texels);
    EXPECT_EQ(turned.rows, tiles) << texels;
  }
}

// Not a tile's bytes: one of their bits more or less, whichever it is.
TEST(Image, OfTilesHasPitchAndAddressInWholeTiles) {
  alignas(64) static std::array<char, 1024> block{};
  for (const selvage_format format : {SELVAGE_INDEX8, SELVAGE_RGB565, SELVAGE_RGBA8888}) {
    const ptrdiff_t tile = 16 * bytes_per_pixel(format);
    selvage_texture tiles{block.data(), 4, 4, 2 * tile, format, SELVAGE_LAYOUT_TILES, nullptr};
    EXPECT_EQ(check_texture(&tiles), SELVAGE_OK);
    for (ptrdiff_t beside = 1; beside < tile; ++beside) {
      tiles.pitch = 2 * tile + beside;
      EXPECT_EQ(check_texture(&tiles), SELVAGE_ERROR_TEXTURE_PITCH) << beside;
      tiles.pitch = 2 * tile;
      tiles.texels = block.data() + beside;
      EXPECT_EQ(check_texture(&tiles), SELVAGE_ERROR_TEXTURE_ALIGNMENT) << beside;
      tiles.texels = block.data();
    }
  }
}

}  // namespace
}  // namespace selvage::mapper
