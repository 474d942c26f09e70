// Images and textures: what makes one valid, and where its bytes are.
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
  const uintptr_t most = (UINTPTR_MAX - begin) / bytes_per_value;
  return {begin, begin + std::min(uintptr_t{count}, most) * bytes_per_value};
}
// From the first pixel's byte to the last's; of a texture, to the end of its sums. The image must
// have passed its checks.
[[nodiscard]] Memory memory_of(const selvage_image& image);
[[nodiscard]] Memory memory_of(const selvage_texture& texture);

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
  const ptrdiff_t texel = bytes_per_pixel(format);
  if (layout == SELVAGE_LAYOUT_ROWS) return {width * texel, height};
  return {units(width, kTileSide_texel) * kTileTexels * texel, units(height, kTileSide_texel)};
}
[[nodiscard]] inline RowsOfBytes rows_of_bytes(const selvage_image& image) {
  return rows_of_bytes(SELVAGE_LAYOUT_ROWS, image.format, image.width, image.height);
}
[[nodiscard]] inline RowsOfBytes rows_of_bytes(const selvage_texture& texture) {
  return rows_of_bytes(texture.layout, texture.format, texture.width, texture.height);
}
[[nodiscard]] bool layout_is_known(selvage_layout layout);

// Each returns SELVAGE_OK or the error of the first rule that is broken.
[[nodiscard]] selvage_status check_target(const selvage_image* target);
[[nodiscard]] selvage_status check_texture(const selvage_texture* texture);
// Both images must have passed the checks above.
[[nodiscard]] selvage_status check_pair(const selvage_image& target,
                                        const selvage_texture& texture);
[[nodiscard]] inline selvage_status check_vertices(const Memory& target,
                                                   const selvage_vertex* vertices, size_t count) {
  if (vertices == nullptr) return SELVAGE_ERROR_VERTICES_NULL;
  if (count < 3) return SELVAGE_ERROR_VERTEX_COUNT;
  const Memory bytes = memory_of(vertices, count, sizeof(selvage_vertex));
  return target.meets(bytes) ? SELVAGE_ERROR_OVERLAP : SELVAGE_OK;
}

// The clip rectangle within the target; NULL is all of it.
[[nodiscard]] selvage_rect visible_rect(const selvage_image& target, const selvage_rect* clip);

}  // namespace selvage::mapper
