// The texture whose texels tell their own places, whatever the format.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "spec/case.h"
#include "spec/exact.h"
#include "spec/filter.h"

namespace selvage::spec {

// The value of texel (s, t) of the coordinate texture: its own place, s in the lower 16 bits.
[[nodiscard]] uint32_t coordinate_texel(int32_t s, int32_t t);
[[nodiscard]] TexelAt coordinate_texture();
[[nodiscard]] Texel texel_of(uint32_t coordinate_value);
// The same for a texel that is first addressed into the case's texture.
[[nodiscard]] uint32_t addressed_value(const Case& c, Texel texel);
// "texel (s, t)".
[[nodiscard]] std::string describe_texel(uint32_t coordinate_value);

// A texture whose values the format holds: coordinates, of 8 bits each in RGB565 and of 4 in
// INDEX8, and what is above these mixed in, so that texels differ whose coordinates differ in one
// bit.
[[nodiscard]] TexelAt folded_texture(selvage_format format);
// The texel of the case's texture that has this value; empty where none has, or several may.
[[nodiscard]] std::optional<Texel> texel_of_folded(const Case& c, uint32_t value);

// Values of a narrow format hold a part of the bits, a digit each of s and of t. So many texels of
// the case's format tell a place in its texture:
[[nodiscard]] int digits(const Case& c);
[[nodiscard]] TexelAt digit_texture(selvage_format format, int digit);
// The part of a coordinate value that a pixel of digit_texture() tells.
[[nodiscard]] uint32_t coordinate_part(selvage_format format, int digit, uint32_t value);

}  // namespace selvage::spec
