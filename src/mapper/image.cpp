#include "mapper/image.h"

#include <algorithm>
#include <cstdint>

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

[[nodiscard]] Footprint footprint(const void* pixels, int32_t width, int32_t height,
                                  ptrdiff_t pitch, selvage_format format) {
  const auto rows = static_cast<uintptr_t>(height);
  const uintptr_t stride = magnitude(pitch);
  auto first = reinterpret_cast<uintptr_t>(pixels);
  if (pitch < 0) first -= (rows - 1) * stride;
  return Footprint{first, static_cast<uintptr_t>(width * bytes_per_pixel(format)), stride, rows};
}

[[nodiscard]] Footprint footprint(const selvage_image& image) {
  return footprint(image.pixels, image.width, image.height, image.pitch, image.format);
}

[[nodiscard]] Footprint footprint(const selvage_texture& texture) {
  return footprint(texture.texels, texture.width, texture.height, texture.pitch, texture.format);
}

// |pitch| holds a row of whole pixels, and the image spans at most PTRDIFF_MAX bytes.
[[nodiscard]] bool pitch_is_valid(int32_t width, int32_t height, ptrdiff_t pitch,
                                  selvage_format format) {
  const auto pixel = static_cast<uintptr_t>(bytes_per_pixel(format));
  const uintptr_t stride = magnitude(pitch);
  const uintptr_t row = static_cast<uintptr_t>(width) * pixel;
  if (stride < row || stride % pixel != 0) return false;
  const auto steps = static_cast<uintptr_t>(height - 1);
  return steps == 0 || stride <= (static_cast<uintptr_t>(PTRDIFF_MAX) - row) / steps;
}

[[nodiscard]] bool format_is_known(selvage_format format) {
  return SELVAGE_INDEX8 <= format && format <= SELVAGE_RGBA8888;
}

[[nodiscard]] bool is_aligned(const void* pixels, selvage_format format) {
  return reinterpret_cast<uintptr_t>(pixels) % static_cast<uintptr_t>(bytes_per_pixel(format)) == 0;
}

// Two rectangles of one bitmap: equal strides, and column ranges that never meet.
[[nodiscard]] bool interleave(const Footprint& a, const Footprint& b) {
  if (a.stride_bytes != b.stride_bytes) return false;
  const uintptr_t stride = a.stride_bytes;
  const uintptr_t b_column = (b.first_byte % stride + stride - a.first_byte % stride) % stride;
  return a.row_bytes <= b_column && b_column + b.row_bytes <= stride;
}

}  // namespace

Memory memory_of(const void* values, size_t count, size_t bytes_per_value) {
  const auto begin = reinterpret_cast<uintptr_t>(values);
  const uintptr_t most = (UINTPTR_MAX - begin) / bytes_per_value;
  return {begin, begin + std::min(uintptr_t{count}, most) * bytes_per_value};
}

Memory memory_of(const selvage_image& image) { return footprint(image).memory(); }

Memory memory_of(const selvage_texture& texture) { return footprint(texture).memory(); }

selvage_status check_target(const selvage_image* target) {
  if (target == nullptr || target->pixels == nullptr) return SELVAGE_ERROR_TARGET_NULL;
  const auto& [pixels, width, height, pitch, format] = *target;
  if (!format_is_known(format)) return SELVAGE_ERROR_TARGET_FORMAT;
  if (width < 1 || height < 1) return SELVAGE_ERROR_TARGET_SIZE;
  if (!pitch_is_valid(width, height, pitch, format)) return SELVAGE_ERROR_TARGET_PITCH;
  if (!is_aligned(pixels, format)) return SELVAGE_ERROR_TARGET_ALIGNMENT;
  return SELVAGE_OK;
}

selvage_status check_texture(const selvage_texture* texture) {
  if (texture == nullptr || texture->texels == nullptr) return SELVAGE_ERROR_TEXTURE_NULL;
  const auto& [texels, width, height, pitch, format, layout, prepared] = *texture;
  if (!format_is_known(format)) return SELVAGE_ERROR_TEXTURE_FORMAT;
  if (width < 1 || height < 1) return SELVAGE_ERROR_TEXTURE_SIZE;
  if (!pitch_is_valid(width, height, pitch, format)) return SELVAGE_ERROR_TEXTURE_PITCH;
  if (!is_aligned(texels, format)) return SELVAGE_ERROR_TEXTURE_ALIGNMENT;
  if (layout != SELVAGE_LAYOUT_ROWS || prepared != nullptr) return SELVAGE_ERROR_TEXTURE_LAYOUT;
  return SELVAGE_OK;
}

selvage_status check_pair(const selvage_image& target, const selvage_texture& texture) {
  if (target.format != texture.format) return SELVAGE_ERROR_FORMAT_MISMATCH;
  const Footprint a = footprint(target), b = footprint(texture);
  return a.memory().meets(b.memory()) && !interleave(a, b) ? SELVAGE_ERROR_OVERLAP : SELVAGE_OK;
}

selvage_status check_vertices(const selvage_image& target, const selvage_vertex* vertices,
                              size_t count) {
  if (vertices == nullptr) return SELVAGE_ERROR_VERTICES_NULL;
  if (count < 3) return SELVAGE_ERROR_VERTEX_COUNT;
  const Memory bytes = memory_of(vertices, count, sizeof(selvage_vertex));
  return memory_of(target).meets(bytes) ? SELVAGE_ERROR_OVERLAP : SELVAGE_OK;
}

selvage_rect visible_rect(const selvage_image& target, const selvage_rect* clip) {
  if (clip == nullptr) return selvage_rect{0, 0, target.width, target.height};
  return selvage_rect{std::max(clip->left, 0), std::max(clip->top, 0),
                      std::min(clip->right, target.width), std::min(clip->bottom, target.height)};
}

}  // namespace selvage::mapper
