// What makes images and textures valid. Small polygons are drawn a call each, and every call checks
// its images: so all of it can be inlined.
#pragma once

#include <cstddef>
#include <cstdint>

#include "mapper/image.h"
#include "mapper/sums.h"

namespace selvage::mapper {

// Of a power of two.
[[nodiscard]] inline bool is_multiple(uintptr_t value, ptrdiff_t unit) {
  return (value & static_cast<uintptr_t>(unit - 1)) == 0;
}
[[nodiscard]] inline bool is_aligned(const void* pixels, ptrdiff_t unit) {
  return is_multiple(reinterpret_cast<uintptr_t>(pixels), unit);
}

// |pitch| holds a row and is a multiple of `unit`, and the image spans at most PTRDIFF_MAX bytes.
[[nodiscard]] inline bool pitch_is_valid(RowsOfBytes size, ptrdiff_t pitch, ptrdiff_t unit) {
  if (size.row_bytes > PTRDIFF_MAX) return false;
  const uintptr_t stride = stride_of(pitch);
  const auto row = static_cast<uintptr_t>(size.row_bytes);
  if (stride < row || !is_multiple(stride, unit)) return false;
  uintptr_t to_last_row;
  if (__builtin_mul_overflow(stride, static_cast<uintptr_t>(size.rows - 1), &to_last_row)) {
    return false;
  }
  constexpr uintptr_t kMostBytes = PTRDIFF_MAX;
  return to_last_row <= kMostBytes && row <= kMostBytes - to_last_row;
}

[[nodiscard]] inline bool format_is_known(selvage_format format) {
  return SELVAGE_INDEX8 <= format && format <= SELVAGE_RGBA8888;
}
[[nodiscard]] inline bool layout_is_known(selvage_layout layout) {
  return layout == SELVAGE_LAYOUT_ROWS || layout == SELVAGE_LAYOUT_TILES;
}

// What addresses and pitches are multiples of, a power of two: a texel, or a tile.
[[nodiscard]] inline ptrdiff_t unit_bytes(selvage_layout layout, selvage_format format) {
  return (layout == SELVAGE_LAYOUT_TILES ? kTileTexels : 1) * bytes_per_pixel(format);
}

// Each returns SELVAGE_OK or the error of the first rule that is broken.
[[nodiscard]] inline selvage_status check_target(const selvage_image* target) {
  if (target == nullptr || target->pixels == nullptr) return SELVAGE_ERROR_TARGET_NULL;
  const auto& [pixels, width, height, pitch, format] = *target;
  if (!format_is_known(format)) return SELVAGE_ERROR_TARGET_FORMAT;
  if (width < 1 || height < 1) return SELVAGE_ERROR_TARGET_SIZE;
  const ptrdiff_t unit = bytes_per_pixel(format);
  if (!pitch_is_valid(rows_of_bytes(*target), pitch, unit)) return SELVAGE_ERROR_TARGET_PITCH;
  if (!is_aligned(pixels, unit)) return SELVAGE_ERROR_TARGET_ALIGNMENT;
  return SELVAGE_OK;
}

[[nodiscard]] inline selvage_status check_texture(const selvage_texture* texture) {
  if (texture == nullptr || texture->texels == nullptr) return SELVAGE_ERROR_TEXTURE_NULL;
  const auto& [texels, width, height, pitch, format, layout, prepared] = *texture;
  if (!format_is_known(format)) return SELVAGE_ERROR_TEXTURE_FORMAT;
  if (width < 1 || height < 1) return SELVAGE_ERROR_TEXTURE_SIZE;
  if (!layout_is_known(layout)) return SELVAGE_ERROR_TEXTURE_LAYOUT;
  const ptrdiff_t unit = unit_bytes(layout, format);
  const bool goes_up = layout == SELVAGE_LAYOUT_TILES && pitch < 0;
  if (goes_up || !pitch_is_valid(rows_of_bytes(*texture), pitch, unit)) {
    return SELVAGE_ERROR_TEXTURE_PITCH;
  }
  if (!is_aligned(texels, unit)) return SELVAGE_ERROR_TEXTURE_ALIGNMENT;
  return prepared == nullptr || prepared == place_of_sums(*texture)
             ? SELVAGE_OK
             : SELVAGE_ERROR_TEXTURE_PREPARED;
}

// Both images must have passed the checks above.
[[nodiscard]] inline selvage_status check_pair(const selvage_image& target,
                                               const selvage_texture& texture) {
  if (target.format != texture.format) return SELVAGE_ERROR_FORMAT_MISMATCH;
  const Memory texels = memory_of_rows(texture.texels, rows_of_bytes(texture), texture.pitch);
  const bool may_meet = memory_of(target).meets(texels) || texture.prepared != nullptr;
  return may_meet && share_bytes(target, texture) ? SELVAGE_ERROR_OVERLAP : SELVAGE_OK;
}

[[nodiscard]] inline selvage_status check_vertices(const Memory& target,
                                                   const selvage_vertex* vertices, size_t count) {
  if (vertices == nullptr) return SELVAGE_ERROR_VERTICES_NULL;
  if (count < 3) return SELVAGE_ERROR_VERTEX_COUNT;
  const Memory bytes = memory_of(vertices, count, sizeof(selvage_vertex));
  return target.meets(bytes) ? SELVAGE_ERROR_OVERLAP : SELVAGE_OK;
}

}  // namespace selvage::mapper
