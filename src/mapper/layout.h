// Layouts: where in memory the texels of a texture are.
//
// The place of texel (s, t), counted in texels from the first, is row(t) + column(s). Pitches are
// in texels here; s and t have been addressed.
#pragma once

#include <cstddef>
#include <cstdint>

#include "mapper/image.h"
#include "selvage.h"

namespace selvage::mapper {

struct Rows {
  [[nodiscard]] static constexpr ptrdiff_t row(int32_t t, ptrdiff_t pitch_texel) {
    return t * pitch_texel;
  }
  [[nodiscard]] static constexpr ptrdiff_t column(int32_t s) { return s; }
};

// Tiles of 4 x 4 texels: the texels of a tile row by row, the tiles row by row.
struct Tiles {
  [[nodiscard]] static constexpr ptrdiff_t row(int32_t t, ptrdiff_t pitch_texel) {
    return (t >> kTileBits) * pitch_texel + ((t & kInTile) << kTileBits);
  }
  [[nodiscard]] static constexpr ptrdiff_t column(int32_t s) {
    return ptrdiff_t{s & ~kInTile} * kTileSide_texel + (s & kInTile);
  }
  static constexpr int32_t kInTile = kTileSide_texel - 1;
};

// Calls draw with the layout's type.
template <class Draw>
decltype(auto) with_layout(selvage_layout layout, const Draw& draw) {
  return layout == SELVAGE_LAYOUT_TILES ? draw(Tiles()) : draw(Rows());
}

// The pitch of rows so long that starts at a cache line and is an odd number of them. So the texels
// of one column fall into all of a cache's sets, one after another; with a power of two they would
// fall into few, and push each other out long before the next column wants their lines.
inline constexpr int64_t kLineBytes = 64;
[[nodiscard]] constexpr int64_t padded_pitch(int64_t row_bytes) {
  return ((row_bytes + kLineBytes - 1) / kLineBytes | 1) * kLineBytes;
}

// Texels that follow each other in memory from column s on, at most.
[[nodiscard]] constexpr int32_t run_texel(selvage_layout layout, int32_t s, int32_t width_texel) {
  const int32_t to_end = width_texel - s;
  const int32_t in_tile = kTileSide_texel - (s & Tiles::kInTile);
  return layout == SELVAGE_LAYOUT_TILES && in_tile < to_end ? in_tile : to_end;
}

[[nodiscard]] constexpr ptrdiff_t pitch_texel_of(const selvage_texture& texture) {
  return texture.pitch >> pixel_shift(texture.format);
}

// The bytes from a texture's first texel to this one.
[[nodiscard]] inline ptrdiff_t texel_offset(const selvage_texture& texture, int32_t s, int32_t t) {
  return with_layout(texture.layout,
                     [&](auto layout) {
                       return layout.row(t, pitch_texel_of(texture)) + layout.column(s);
                     }) *
         bytes_per_pixel(texture.format);
}

}  // namespace selvage::mapper
