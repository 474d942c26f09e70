#include "scene/paints.h"

#include <algorithm>

namespace selvage::scene {
namespace {

inline constexpr int32_t kTexelBytes = 4;

[[nodiscard]] selvage_texture rows(const uint8_t* texels, int32_t width_texel,
                                   int32_t height_texel) {
  return {texels,           width_texel,         height_texel, width_texel * kTexelBytes,
          SELVAGE_RGBA8888, SELVAGE_LAYOUT_ROWS, nullptr};
}

[[nodiscard]] bool is_within(const selvage_rect& inner, const selvage_rect& outer) {
  return inner.left >= outer.left && inner.top >= outer.top && inner.right <= outer.right &&
         inner.bottom <= outer.bottom;
}

[[nodiscard]] selvage_rect around(const selvage_rect& a, const selvage_rect& b) {
  if (a.left == a.right) return b;
  return {std::min(a.left, b.left), std::min(a.top, b.top), std::max(a.right, b.right),
          std::max(a.bottom, b.bottom)};
}

}  // namespace

selvage_texture Paints::texture(const Paint& paint) {
  if (!paint.texture) return rows(colour(paint.colour).data(), 1, 1);
  const TextureImage& image = scene_.textures[*paint.texture];
  return texture(paint, {0, 0, image.width_texel, image.height_texel});
}

selvage_texture Paints::texture(const Paint& paint, const selvage_rect& texels,
                                double spared_texels) {
  const TextureImage& image = scene_.textures[*paint.texture];
  if (paint.light == Light{}) {
    return sums_.of(*paint.texture, rows(image.rgba.data(), image.width_texel, image.height_texel),
                    spared_texels);
  }
  Copy& copy = copy_of(*paint.texture, paint.light);
  if (!is_within(texels, copy.lit)) light_texels(copy, texels);
  return rows(copy.rgba.get(), image.width_texel, image.height_texel);
}

const std::vector<uint8_t>& Paints::colour(const Colour& colour) {
  const uint32_t key = uint32_t{colour.red} | uint32_t{colour.green} << 8 |
                       uint32_t{colour.blue} << 16 | uint32_t{colour.alpha} << 24;
  std::vector<uint8_t>& texel = colours_[key];
  if (texel.empty()) texel = {colour.red, colour.green, colour.blue, colour.alpha};
  return texel;
}

Paints::Copy& Paints::copy_of(size_t texture, const Light& light) {
  const auto known = std::ranges::find_if(
      copies_, [&](const Copy& copy) { return copy.texture == texture && copy.light == light; });
  if (known != copies_.end()) {
    copies_.splice(copies_.begin(), copies_, known);
    return copies_.front();
  }
  const size_t bytes = scene_.textures[texture].rgba.size();
  for (; !copies_.empty() && bytes_ + bytes > most_bytes_; copies_.pop_back()) {
    bytes_ -= copies_.back().bytes;
  }
  bytes_ += bytes;
  copies_.push_front({texture, light, bytes, std::make_unique_for_overwrite<uint8_t[]>(bytes), {}});
  return copies_.front();
}

// What is lit stays a rectangle; nothing in it is lit twice.
void Paints::light_texels(Copy& copy, const selvage_rect& texels) {
  const int64_t start_ns = now_ns_();
  const TextureImage& image = scene_.textures[copy.texture];
  const auto light_row = [&](int32_t row, int32_t first, int32_t end) {
    for (int32_t column = first; column < end; ++column) {
      const size_t at =
          kTexelBytes * (static_cast<size_t>(row) * static_cast<size_t>(image.width_texel) +
                         static_cast<size_t>(column));
      copy.rgba[at] = lit(image.rgba[at], copy.light.red);
      copy.rgba[at + 1] = lit(image.rgba[at + 1], copy.light.green);
      copy.rgba[at + 2] = lit(image.rgba[at + 2], copy.light.blue);
      copy.rgba[at + 3] = image.rgba[at + 3];
    }
    lit_texels_ += std::max(0, end - first);
  };
  const selvage_rect wanted = around(copy.lit, texels);
  for (int32_t row = wanted.top; row < wanted.bottom; ++row) {
    const bool is_begun = row >= copy.lit.top && row < copy.lit.bottom;
    light_row(row, wanted.left, is_begun ? copy.lit.left : wanted.right);
    if (is_begun) light_row(row, copy.lit.right, wanted.right);
  }
  copy.lit = wanted;
  light_ns_ += now_ns_() - start_ns;
}

}  // namespace selvage::scene
