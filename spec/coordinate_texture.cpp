#include "spec/coordinate_texture.h"

#include <algorithm>

namespace selvage::spec {
namespace {

// How many bits of s and of t a format's texel holds.
[[nodiscard]] int coordinate_bits(selvage_format format) {
  return format == SELVAGE_INDEX8 ? 4 : format == SELVAGE_RGB565 ? 8 : 16;
}

[[nodiscard]] uint32_t digit_value(selvage_format format, int32_t s, int32_t t) {
  const int bits = coordinate_bits(format);
  const uint32_t mask = (1U << bits) - 1;
  return (static_cast<uint32_t>(s) & mask) | (static_cast<uint32_t>(t) & mask) << bits;
}

// A coordinate with its higher digits mixed into the lowest.
[[nodiscard]] int32_t folded(int32_t coordinate, int bits) {
  constexpr int32_t kFactor = 5;
  return coordinate >> bits == 0 ? coordinate
                                 : coordinate + kFactor * folded(coordinate >> bits, bits);
}

}  // namespace

uint32_t coordinate_texel(int32_t s, int32_t t) { return digit_value(SELVAGE_RGBA8888, s, t); }

TexelAt coordinate_texture() {
  return [](Texel texel) { return coordinate_texel(texel.s, texel.t); };
}

Texel texel_of(uint32_t coordinate_value) {
  return {static_cast<int32_t>(coordinate_value & 0xFFFF),
          static_cast<int32_t>(coordinate_value >> 16)};
}

uint32_t addressed_value(const Case& c, Texel texel) {
  return coordinate_texel(address_texel(texel.s, c.texture_width_texel, c.address),
                          address_texel(texel.t, c.texture_height_texel, c.address));
}

std::string describe_texel(uint32_t coordinate_value) {
  const Texel texel = texel_of(coordinate_value);
  return "texel (" + std::to_string(texel.s) + ", " + std::to_string(texel.t) + ")";
}

TexelAt folded_texture(selvage_format format) {
  const int bits = coordinate_bits(format);
  return [=](Texel texel) {
    return digit_value(format, folded(texel.s, bits), folded(texel.t, bits));
  };
}

std::optional<Texel> texel_of_folded(const Case& c, uint32_t value) {
  if (digits(c) > 1) return std::nullopt;
  const Texel texel = texel_of(coordinate_part(c.format, 0, value));
  const bool is_inside = texel.s < c.texture_width_texel && texel.t < c.texture_height_texel;
  return is_inside ? std::optional(texel) : std::nullopt;
}

int digits(const Case& c) {
  const int32_t last_texel = std::max(c.texture_width_texel, c.texture_height_texel) - 1;
  const int bits = coordinate_bits(c.format);
  int count = 1;
  while (last_texel >> bits * count != 0) ++count;
  return count;
}

TexelAt digit_texture(selvage_format format, int digit) {
  const int shift = coordinate_bits(format) * digit;
  return [=](Texel texel) { return digit_value(format, texel.s >> shift, texel.t >> shift); };
}

uint32_t coordinate_part(selvage_format format, int digit, uint32_t value) {
  const int bits = coordinate_bits(format);
  const uint32_t mask = (1U << bits) - 1;
  return (value & mask) << bits * digit | (value >> bits & mask) << (16 + bits * digit);
}

}  // namespace selvage::spec
