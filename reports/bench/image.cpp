#include "reports/bench/image.h"

namespace selvage::reports {

namespace {

constexpr int32_t kPixelBytes = 4;
constexpr int32_t kPaddingTexels = 16;

}  // namespace

Target::Target(int32_t width, int32_t height)
    : width_px(width),
      height_px(height),
      pixels(static_cast<size_t>(width) * static_cast<size_t>(height), kUntouched) {}

uint32_t* Target::row(int32_t y_px) {
  return pixels.data() + static_cast<ptrdiff_t>(y_px) * width_px;
}

const uint32_t* Target::row(int32_t y_px) const {
  return pixels.data() + static_cast<ptrdiff_t>(y_px) * width_px;
}

selvage_image Target::image() {
  return {pixels.data(), width_px, height_px, static_cast<ptrdiff_t>(width_px) * kPixelBytes,
          SELVAGE_RGBA8888};
}

Texture::Texture(int32_t side)
    : side_texel(side),
      pitch_texel(side + kPaddingTexels),
      texels(static_cast<size_t>(pitch_texel) * static_cast<size_t>(side), kUntouched) {
  for (int32_t t = 0; t < side; ++t) {
    uint32_t* row = texels.data() + static_cast<ptrdiff_t>(t) * pitch_texel;
    for (int32_t s = 0; s < side; ++s) row[s] = place_of(s, t);
  }
}

selvage_texture Texture::view() const {
  return {
      texels.data(),    side_texel,          side_texel, static_cast<ptrdiff_t>(pitch_texel) * 4,
      SELVAGE_RGBA8888, SELVAGE_LAYOUT_ROWS, nullptr};
}

}  // namespace selvage::reports
