// Images and textures: where their bytes are.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "selvage.h"

namespace selvage::mapper {

// Bytes of a pixel, as a power of two. The format must be valid.
[[nodiscard]] constexpr int pixel_shift(selvage_format format) {
  return format == SELVAGE_INDEX8 ? 0 : format == SELVAGE_RGB565 ? 1 : 2;
}
[[nodiscard]] constexpr ptrdiff_t bytes_per_pixel(selvage_format format) {
  return ptrdiff_t{1} << pixel_shift(format);
}

// Addresses of bytes, [begin, end).
struct Memory {
  uintptr_t begin, end;

  [[nodiscard]] bool meets(const Memory& other) const {
    return begin < other.end && other.begin < end;
  }
};
// Of so many values; where they would reach beyond the last address, up to there.
[[nodiscard]] inline Memory memory_of(const void* values, size_t count, size_t bytes_per_value) {
  const auto begin = reinterpret_cast<uintptr_t>(values);
  uintptr_t bytes, end;
  const bool reaches_beyond = __builtin_mul_overflow(count, bytes_per_value, &bytes) ||
                              __builtin_add_overflow(begin, bytes, &end);
  return {begin, reaches_beyond ? UINTPTR_MAX : end};
}

inline constexpr int kTileBits = 2;
inline constexpr int32_t kTileSide_texel = 1 << kTileBits;
inline constexpr int32_t kTileTexels = kTileSide_texel * kTileSide_texel;

// So many of `unit` hold `size`.
[[nodiscard]] constexpr int64_t units(int32_t size, int32_t unit) {
  return (int64_t{size} + unit - 1) / unit;
}

// How a texture is stepped through: `rows` times `row_bytes`, a pitch apart.
struct RowsOfBytes {
  int64_t row_bytes, rows;
};
// Of a valid format and layout: its rows, or its rows of tiles.
[[nodiscard]] constexpr RowsOfBytes rows_of_bytes(selvage_layout layout, selvage_format format,
                                                  int32_t width, int32_t height) {
  const int64_t texel = bytes_per_pixel(format);
  if (layout == SELVAGE_LAYOUT_ROWS) return {width * texel, height};
  return {units(width, kTileSide_texel) * kTileTexels * texel, units(height, kTileSide_texel)};
}
[[nodiscard]] inline RowsOfBytes rows_of_bytes(const selvage_image& image) {
  return rows_of_bytes(SELVAGE_LAYOUT_ROWS, image.format, image.width, image.height);
}
[[nodiscard]] inline RowsOfBytes rows_of_bytes(const selvage_texture& texture) {
  return rows_of_bytes(texture.layout, texture.format, texture.width, texture.height);
}

[[nodiscard]] constexpr uintptr_t stride_of(ptrdiff_t pitch) {
  return pitch < 0 ? uintptr_t{0} - static_cast<uintptr_t>(pitch) : static_cast<uintptr_t>(pitch);
}

// From the first pixel's byte to the last's: `size.rows` rows at `pitch`. Where they would reach to
// the last address or beyond, up to there.
[[nodiscard]] inline Memory memory_of_rows(const void* pixels, RowsOfBytes size, ptrdiff_t pitch) {
  const uintptr_t to_last_row = static_cast<uintptr_t>(size.rows - 1) * stride_of(pitch);
  const auto first = reinterpret_cast<uintptr_t>(pixels);
  const uintptr_t begin = pitch < 0 ? first - to_last_row : first;
  uintptr_t end;
  const bool reaches_beyond =
      __builtin_add_overflow(begin, to_last_row + static_cast<uintptr_t>(size.row_bytes), &end);
  return {begin, reaches_beyond ? UINTPTR_MAX : end};
}

// The end of the sums of a texture that has some.
[[nodiscard]] uintptr_t end_of_sums(const selvage_texture& texture);

// Of an image that has passed its checks; of a texture, to the end of its sums.
[[nodiscard]] inline Memory memory_of(const selvage_image& image) {
  return memory_of_rows(image.pixels, rows_of_bytes(image), image.pitch);
}
[[nodiscard]] inline Memory memory_of(const selvage_texture& texture) {
  const Memory texels = memory_of_rows(texture.texels, rows_of_bytes(texture), texture.pitch);
  return texture.prepared == nullptr ? texels : Memory{texels.begin, end_of_sums(texture)};
}

// Whether a pixel of the target and a texel or a sum share a byte. Two rectangles of one bitmap do
// not, where their columns never meet.
[[nodiscard]] bool share_bytes(const selvage_image& target, const selvage_texture& texture);

// The clip rectangle within the target; NULL is all of it.
[[nodiscard]] inline selvage_rect visible_rect(const selvage_image& target,
                                               const selvage_rect* clip) {
  if (clip == nullptr) return {0, 0, target.width, target.height};
  return {std::max<int32_t>(clip->left, 0), std::max<int32_t>(clip->top, 0),
          std::min(clip->right, target.width), std::min(clip->bottom, target.height)};
}

}  // namespace selvage::mapper
