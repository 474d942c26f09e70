#include "mapper/copy_row.h"

#include <algorithm>
#include <cstddef>
#include <cstring>

#include "mapper/address.h"
#include "mapper/image.h"
#include "mapper/layout.h"

namespace selvage::mapper {
namespace {

[[nodiscard]] int32_t index(int32_t texel, int32_t size_texel, selvage_address address) {
  return address == SELVAGE_ADDRESS_CLAMP ? Clamp::index(texel, size_texel)
                                          : Wrap::index(texel, size_texel);
}

// Fills `total` bytes with copies of the first `unit` bytes of `source`.
void repeat(const char* source, size_t unit, size_t total, char* pixels) {
  std::memcpy(pixels, source, unit);
  for (size_t filled = unit; filled < total;) {
    const size_t piece = std::min(filled, total - filled);
    std::memcpy(pixels + filled, pixels, piece);
    filled += piece;
  }
}

template <size_t kTexelBytes>
void copy_fours(const char* source, int32_t count, char* pixels) {
  for (int32_t i = 0; i < count; ++i) {
    std::memcpy(pixels, source, kTileSide_texel * kTexelBytes);
    source += kTileTexels * kTexelBytes;
    pixels += kTileSide_texel * kTexelBytes;
  }
}

// A row of whole tiles.
void copy_tiles(const char* source, int32_t tiles, size_t unit, char* pixels) {
  if (unit == 1) return copy_fours<1>(source, tiles, pixels);
  return unit == 2 ? copy_fours<2>(source, tiles, pixels) : copy_fours<4>(source, tiles, pixels);
}

}  // namespace

void copy_row(const selvage_texture& texture, selvage_address address, int32_t s, int32_t t,
              int32_t width_px, char* pixels) {
  const auto unit = static_cast<size_t>(bytes_per_pixel(texture.format));
  const char* const texels = static_cast<const char*>(texture.texels);
  const int32_t row = index(t, texture.height, address);
  while (width_px > 0) {
    const int32_t column = index(s, texture.width, address);
    const char* source = texels + texel_offset(texture, column, row);
    const bool clamped = column != s && address == SELVAGE_ADDRESS_CLAMP;
    const int32_t to_end_px = std::min(texture.width - column, width_px);
    const int32_t tiles = texture.layout == SELVAGE_LAYOUT_TILES && column % kTileSide_texel == 0
                              ? to_end_px / kTileSide_texel
                              : 0;
    const int32_t run_px = clamped     ? (s < 0 ? -s : width_px)
                           : tiles > 0 ? tiles * kTileSide_texel
                                       : run_texel(texture.layout, column, texture.width);
    const int32_t piece_px = std::min(run_px, width_px);
    const size_t bytes = static_cast<size_t>(piece_px) * unit;
    if (clamped) {
      repeat(source, unit, bytes, pixels);
    } else if (tiles > 0) {
      copy_tiles(source, tiles, unit, pixels);
    } else {
      std::memcpy(pixels, source, bytes);
    }
    pixels += bytes;
    s += piece_px;
    width_px -= piece_px;
  }
}

}  // namespace selvage::mapper
