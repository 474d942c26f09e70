#include "scene/paints.h"

namespace selvage::scene {
namespace {

inline constexpr int32_t kTexelBytes = 4;

[[nodiscard]] selvage_texture rows(const std::vector<uint8_t>& texels, int32_t width_texel,
                                   int32_t height_texel) {
  return {texels.data(),    width_texel,         height_texel, width_texel * kTexelBytes,
          SELVAGE_RGBA8888, SELVAGE_LAYOUT_ROWS, nullptr};
}

}  // namespace

selvage_texture Paints::texture(const Paint& paint) {
  if (!paint.texture) return rows(colour(paint.colour), 1, 1);
  const TextureImage& image = scene_.textures[*paint.texture];
  const Texels& texels =
      paint.light == Light{} ? image.rgba : lit_copy(*paint.texture, paint.light);
  return rows(texels, image.width_texel, image.height_texel);
}

const Paints::Texels& Paints::colour(const Colour& colour) {
  const uint32_t key = uint32_t{colour.red} | uint32_t{colour.green} << 8 |
                       uint32_t{colour.blue} << 16 | uint32_t{colour.alpha} << 24;
  Texels& texel = colours_[key];
  if (texel.empty()) texel = {colour.red, colour.green, colour.blue, colour.alpha};
  return texel;
}

const Paints::Texels& Paints::lit_copy(size_t texture, const Light& light) {
  Texels& copy = lit_copies_[{texture, light}];
  if (!copy.empty()) return copy;
  copy = scene_.textures[texture].rgba;
  for (size_t i = 0; i < copy.size(); i += kTexelBytes) {
    copy[i] = lit(copy[i], light.red);
    copy[i + 1] = lit(copy[i + 1], light.green);
    copy[i + 2] = lit(copy[i + 2], light.blue);
  }
  return copy;
}

}  // namespace selvage::scene
