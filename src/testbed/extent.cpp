#include "testbed/extent.h"

#include <cstdint>

namespace selvage::testbed {
namespace {

inline constexpr size_t kTileSide = 4;

[[nodiscard]] uintptr_t address_of(const void* pointer) {
  return reinterpret_cast<uintptr_t>(pointer);
}

// Rows of blocks: pixels, or tiles.
struct Rows {
  const void* first;
  size_t block_bytes, blocks, count;  // of a row; rows
  ptrdiff_t pitch;
};

[[nodiscard]] Range range_of(const Rows& rows, size_t most_bytes) {
  const Range none{address_of(rows.first), address_of(rows.first)};
  if (rows.first == nullptr || rows.pitch == PTRDIFF_MIN) return none;
  const size_t row = rows.blocks * rows.block_bytes;
  const auto stride = static_cast<size_t>(rows.pitch < 0 ? -rows.pitch : rows.pitch);
  const size_t steps = rows.count - 1;
  if (row > stride || row > most_bytes || stride % rows.block_bytes != 0) return none;
  if (steps > 0 && stride > (most_bytes - row) / steps) return none;
  const uintptr_t begin = none.begin - (rows.pitch < 0 ? steps * stride : 0);
  return {begin, begin + steps * stride + row};
}

[[nodiscard]] bool is_picture(int32_t width, int32_t height, selvage_format format) {
  return SELVAGE_INDEX8 <= format && format <= SELVAGE_RGBA8888 && width >= 1 && height >= 1;
}

}  // namespace

size_t bytes_per_pixel(selvage_format format) {
  return format == SELVAGE_INDEX8 ? 1 : format == SELVAGE_RGB565 ? 2 : 4;
}

size_t unit_of(const selvage_texture& texture) {
  const size_t texel = bytes_per_pixel(texture.format);
  return texture.layout == SELVAGE_LAYOUT_TILES ? texel * kTileSide * kTileSide : texel;
}

Range range_of(const selvage_image* image, size_t most_bytes) {
  if (image == nullptr) return {};
  if (!is_picture(image->width, image->height, image->format)) {
    return {address_of(image->pixels), address_of(image->pixels)};
  }
  return range_of({image->pixels, bytes_per_pixel(image->format), static_cast<size_t>(image->width),
                   static_cast<size_t>(image->height), image->pitch},
                  most_bytes);
}

Range range_of(const selvage_texture* texture, size_t most_bytes) {
  if (texture == nullptr) return {};
  const bool is_tiled = texture->layout == SELVAGE_LAYOUT_TILES;
  if (!is_picture(texture->width, texture->height, texture->format) ||
      (is_tiled && texture->pitch < 0)) {
    return {address_of(texture->texels), address_of(texture->texels)};
  }
  const size_t side = is_tiled ? kTileSide : 1;
  const auto blocks = [&](int32_t length) {
    return (static_cast<size_t>(length) + side - 1) / side;
  };
  return range_of({texture->texels, unit_of(*texture), blocks(texture->width),
                   blocks(texture->height), texture->pitch},
                  most_bytes);
}

Range range_of(const selvage_vertex* vertices, size_t count, size_t most_bytes) {
  const uintptr_t begin = address_of(vertices);
  if (vertices == nullptr || count > most_bytes / sizeof *vertices) return {begin, begin};
  return {begin, begin + count * sizeof *vertices};
}

}  // namespace selvage::testbed
