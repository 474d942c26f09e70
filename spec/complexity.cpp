#include "spec/complexity.h"

#include <bit>

namespace selvage::spec {
namespace {

constexpr int kPositionBits = std::countr_zero(unsigned{SELVAGE_SUBPIXELS});
constexpr int kTexelBits = std::countr_zero(unsigned{SELVAGE_SUBTEXELS});

[[nodiscard]] uint64_t magnitude(int64_t value) {
  return static_cast<uint64_t>(value < 0 ? -value : value);
}

[[nodiscard]] uint64_t fraction_places(int32_t value, int fraction_bits) {
  const int trailing_zeros = std::countr_zero(static_cast<uint32_t>(value));
  return trailing_zeros < fraction_bits ? static_cast<uint64_t>(fraction_bits - trailing_zeros) : 0;
}

[[nodiscard]] uint64_t options_set(const Case& c) {
  return uint64_t{c.has_clip} + uint64_t{c.padding_px > 0} + uint64_t{c.flip_target} +
         uint64_t{c.flip_texture} + uint64_t{c.address != SELVAGE_ADDRESS_CLAMP} +
         uint64_t{c.filter != SELVAGE_FILTER_NEAREST} + uint64_t{c.format != SELVAGE_RGBA8888} +
         uint64_t{c.layout != Layout::kGiven};
}

}  // namespace

Complexity complexity(const Case& c) {
  uint64_t fractions = 0;
  uint64_t magnitudes = magnitude(c.padding_px) + magnitude(c.filter) +
                        magnitude(static_cast<int32_t>(c.layout)) + c.choice +
                        magnitude(c.clip.left) + magnitude(c.clip.top) + magnitude(c.clip.right) +
                        magnitude(c.clip.bottom);
  for (const selvage_vertex& vertex : c.vertices) {
    fractions += fraction_places(vertex.x, kPositionBits) +
                 fraction_places(vertex.y, kPositionBits) + fraction_places(vertex.u, kTexelBits) +
                 fraction_places(vertex.v, kTexelBits);
    magnitudes += magnitude(vertex.x) + magnitude(vertex.y) + magnitude(vertex.u) +
                  magnitude(vertex.v) + magnitude(vertex.q - 1);
  }
  return {c.vertices.size(),
          magnitude(c.target_width_px) + magnitude(c.target_height_px),
          magnitude(c.texture_width_texel) + magnitude(c.texture_height_texel),
          options_set(c),
          fractions,
          magnitudes};
}

}  // namespace selvage::spec
