#include "reports/bench/image.h"

namespace selvage::reports {

namespace {

constexpr int32_t kPixelBytes = 4;
constexpr int32_t kPaddingTexels = 16;
constexpr uint32_t kOpaque = 0xFF000000u;

// Of each bit of the place depends each bit of the result about evenly: the finalizer of
// MurmurHash3 (Austin Appleby, public domain).
uint32_t mixed(uint32_t bits) {
  bits = (bits ^ bits >> 16) * 0x85EBCA6Bu;
  bits = (bits ^ bits >> 13) * 0xC2B2AE35u;
  return bits ^ bits >> 16;
}

}  // namespace

Target::Target(int32_t width, int32_t height, int32_t padding)
    : width_px(width),
      height_px(height),
      pitch_px(width + padding),
      pixels(static_cast<size_t>(pitch_px) * static_cast<size_t>(height), kUntouched) {}

uint32_t* Target::row(int32_t y_px) {
  return pixels.data() + static_cast<ptrdiff_t>(y_px) * pitch_px;
}

const uint32_t* Target::row(int32_t y_px) const {
  return pixels.data() + static_cast<ptrdiff_t>(y_px) * pitch_px;
}

selvage_image Target::image() {
  return {pixels.data(), width_px, height_px, static_cast<ptrdiff_t>(pitch_px) * kPixelBytes,
          SELVAGE_RGBA8888};
}

uint32_t noise_of(int32_t s, int32_t t) {
  constexpr uint32_t levels = 255;  // 0 .. 254
  const uint32_t bits = mixed(place_of(s, t) + 1);
  uint32_t texel = kOpaque;
  for (const uint32_t channel : {0u, 8u, 16u})
    texel |= ((bits >> channel & 0xFF) * levels >> 8) << channel;
  return texel;
}

uint32_t texel_of(Texels kind, int32_t s, int32_t t) {
  return kind == Texels::kPlaces ? place_of(s, t) : noise_of(s, t);
}

Texture::Texture(int32_t side, Texels kind)
    : side_texel(side),
      pitch_texel(side + kPaddingTexels),
      texels(static_cast<size_t>(pitch_texel) * static_cast<size_t>(side), kUntouched) {
  for (int32_t t = 0; t < side; ++t) {
    uint32_t* row = texels.data() + static_cast<ptrdiff_t>(t) * pitch_texel;
    for (int32_t s = 0; s < side; ++s) row[s] = texel_of(kind, s, t);
  }
}

selvage_texture Texture::view() const {
  return {
      texels.data(),    side_texel,          side_texel, static_cast<ptrdiff_t>(pitch_texel) * 4,
      SELVAGE_RGBA8888, SELVAGE_LAYOUT_ROWS, nullptr};
}

}  // namespace selvage::reports
