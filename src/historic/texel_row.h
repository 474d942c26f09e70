// Writing a span from two walks along it, one for s and one for t, whatever arithmetic they have.
//
// A walk is monotone. It has
//   int32_t texel() const        the texel of the pixel it stands on
//   int32_t texel(px) const      the texel `px` pixels further on
//   void step()                  goes to the next pixel
//   bool is_unit() const         every step is one texel, exactly
//   bool is_constant() const     no step leaves the texel
#pragma once

#include <cstdint>
#include <cstring>

#include "mapper/address.h"
#include "mapper/copy_row.h"
#include "selvage.h"

namespace selvage::historic {

// A span that has been clipped: where to write, how much, and what from.
struct TexelRow {
  char* pixels;
  int32_t width_px;  // > 0
  const selvage_texture& texture;
  selvage_address address;
};

template <class Pixel, class Address, class Walk>
void write_texels(const TexelRow& row, Walk s, Walk t) {
  const selvage_texture texture = row.texture;
  const char* texels = static_cast<const char*>(texture.texels);
  char* pixel = row.pixels;
  for (int32_t left_px = row.width_px; left_px > 0; --left_px) {
    const ptrdiff_t column = Address::index(s.texel(), texture.width);
    const ptrdiff_t line = Address::index(t.texel(), texture.height);
    std::memcpy(pixel, texels + line * texture.pitch + column * ptrdiff_t{sizeof(Pixel)},
                sizeof(Pixel));
    pixel += sizeof(Pixel);
    s.step();
    t.step();
  }
}

template <class Walk>
[[nodiscard]] bool stays_inside(const Walk& walk, int32_t width_px, int32_t size_texel) {
  const int32_t first = walk.texel(), last = walk.texel(width_px - 1);
  return 0 <= first && first < size_texel && 0 <= last && last < size_texel;
}

template <class Pixel, class Walk>
void write_pixels(const TexelRow& row, const Walk& s, const Walk& t) {
  if (stays_inside(s, row.width_px, row.texture.width) &&
      stays_inside(t, row.width_px, row.texture.height)) {
    write_texels<Pixel, mapper::Inside>(row, s, t);
  } else if (row.address == SELVAGE_ADDRESS_CLAMP) {
    write_texels<Pixel, mapper::Clamp>(row, s, t);
  } else {
    write_texels<Pixel, mapper::Wrap>(row, s, t);
  }
}

template <class Walk>
void write_row(const TexelRow& row, const Walk& s, const Walk& t) {
  if (s.is_unit() && t.is_constant()) {
    mapper::copy_row(row.texture, row.address, s.texel(), t.texel(), row.width_px, row.pixels);
    return;
  }
  switch (row.texture.format) {
    case SELVAGE_INDEX8:
      return write_pixels<uint8_t>(row, s, t);
    case SELVAGE_RGB565:
      return write_pixels<uint16_t>(row, s, t);
    default:
      return write_pixels<uint32_t>(row, s, t);
  }
}

}  // namespace selvage::historic
