#include "mapper/image.h"

#include <algorithm>
#include <cstdint>

#include "mapper/number.h"
#include "mapper/sums.h"

namespace selvage::mapper {
namespace {

// The bytes of an image: a first address, a number of rows, and row after row at `stride`.
struct Footprint {
  uintptr_t first_byte;
  uintptr_t row_bytes;
  uintptr_t stride_bytes;  // |pitch|
  uintptr_t rows;

  [[nodiscard]] Memory memory() const {
    return {first_byte, first_byte + (rows - 1) * stride_bytes + row_bytes};
  }
};

[[nodiscard]] uintptr_t magnitude(ptrdiff_t pitch) {
  return pitch < 0 ? uintptr_t{0} - static_cast<uintptr_t>(pitch) : static_cast<uintptr_t>(pitch);
}

[[nodiscard]] Footprint footprint(const void* pixels, RowsOfBytes size, ptrdiff_t pitch) {
  const auto rows = static_cast<uintptr_t>(size.rows);
  const uintptr_t stride = magnitude(pitch);
  auto first = reinterpret_cast<uintptr_t>(pixels);
  if (pitch < 0) first -= (rows - 1) * stride;
  return Footprint{first, static_cast<uintptr_t>(size.row_bytes), stride, rows};
}

[[nodiscard]] Footprint footprint(const selvage_image& image) {
  return footprint(image.pixels, rows_of_bytes(image), image.pitch);
}

[[nodiscard]] Footprint footprint(const selvage_texture& texture) {
  return footprint(texture.texels, rows_of_bytes(texture), texture.pitch);
}

// Of a power of two.
[[nodiscard]] bool is_multiple(uintptr_t value, ptrdiff_t unit) {
  return (value & static_cast<uintptr_t>(unit - 1)) == 0;
}

// |pitch| holds a row and is a multiple of `unit`, and the image spans at most PTRDIFF_MAX bytes.
[[nodiscard]] bool pitch_is_valid(RowsOfBytes size, ptrdiff_t pitch, ptrdiff_t unit) {
  const uintptr_t stride = magnitude(pitch);
  const auto row = static_cast<uintptr_t>(size.row_bytes);
  if (stride < row || !is_multiple(stride, unit)) return false;
  const uint128 above_last_row = uint128{stride} * static_cast<uintptr_t>(size.rows - 1);
  return above_last_row + row <= static_cast<uintptr_t>(PTRDIFF_MAX);
}

// What addresses and pitches are multiples of, a power of two: a texel, or a tile.
[[nodiscard]] ptrdiff_t unit_bytes(selvage_layout layout, selvage_format format) {
  return (layout == SELVAGE_LAYOUT_TILES ? kTileTexels : 1) * bytes_per_pixel(format);
}

[[nodiscard]] bool format_is_known(selvage_format format) {
  return SELVAGE_INDEX8 <= format && format <= SELVAGE_RGBA8888;
}

[[nodiscard]] bool is_aligned(const void* pixels, ptrdiff_t unit) {
  return is_multiple(reinterpret_cast<uintptr_t>(pixels), unit);
}

// Two rectangles of one bitmap: equal strides, and column ranges that never meet.
[[nodiscard]] bool interleave(const Footprint& a, const Footprint& b) {
  if (a.stride_bytes != b.stride_bytes) return false;
  const uintptr_t stride = a.stride_bytes;
  const uintptr_t b_column = (b.first_byte % stride + stride - a.first_byte % stride) % stride;
  return a.row_bytes <= b_column && b_column + b.row_bytes <= stride;
}

[[nodiscard]] Memory memory_of_sums(const selvage_texture& texture) {
  const auto begin = reinterpret_cast<uintptr_t>(texture.prepared);
  return {begin, begin + static_cast<uintptr_t>(SumsShape::of(texture).bytes())};
}

}  // namespace

Memory memory_of(const selvage_image& image) { return footprint(image).memory(); }

Memory memory_of(const selvage_texture& texture) {
  const Memory texels = footprint(texture).memory();
  if (texture.prepared == nullptr) return texels;
  return {texels.begin, memory_of_sums(texture).end};
}

bool layout_is_known(selvage_layout layout) {
  return layout == SELVAGE_LAYOUT_ROWS || layout == SELVAGE_LAYOUT_TILES;
}

selvage_status check_target(const selvage_image* target) {
  if (target == nullptr || target->pixels == nullptr) return SELVAGE_ERROR_TARGET_NULL;
  const auto& [pixels, width, height, pitch, format] = *target;
  if (!format_is_known(format)) return SELVAGE_ERROR_TARGET_FORMAT;
  if (width < 1 || height < 1) return SELVAGE_ERROR_TARGET_SIZE;
  const ptrdiff_t unit = bytes_per_pixel(format);
  if (!pitch_is_valid(rows_of_bytes(*target), pitch, unit)) return SELVAGE_ERROR_TARGET_PITCH;
  if (!is_aligned(pixels, unit)) return SELVAGE_ERROR_TARGET_ALIGNMENT;
  return SELVAGE_OK;
}

selvage_status check_texture(const selvage_texture* texture) {
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

selvage_status check_pair(const selvage_image& target, const selvage_texture& texture) {
  if (target.format != texture.format) return SELVAGE_ERROR_FORMAT_MISMATCH;
  const Footprint a = footprint(target), b = footprint(texture);
  if (a.memory().meets(b.memory()) && !interleave(a, b)) return SELVAGE_ERROR_OVERLAP;
  const bool sums_meet = texture.prepared != nullptr && a.memory().meets(memory_of_sums(texture));
  return sums_meet ? SELVAGE_ERROR_OVERLAP : SELVAGE_OK;
}

selvage_rect visible_rect(const selvage_image& target, const selvage_rect* clip) {
  if (clip == nullptr) return selvage_rect{0, 0, target.width, target.height};
  return selvage_rect{std::max(clip->left, 0), std::max(clip->top, 0),
                      std::min(clip->right, target.width), std::min(clip->bottom, target.height)};
}

}  // namespace selvage::mapper
