// A case: everything one drawing needs but the texels and the background, as a plain value.
//
// Cases come from a generator, from a fuzzer's bytes, from an enumeration or from a file; the codec
// and the printer here serve them all. Every byte string decodes to a case, and every case that a
// decoder made is encoded back to bytes that decode to the same case.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "selvage.h"

namespace selvage::spec {

inline constexpr int32_t kMaxTargetPx = 65536;       // width x height of a case's target
inline constexpr int32_t kMaxTextureTexels = 65536;  // width x height of a case's texture
inline constexpr size_t kMaxVertices = 256;
inline constexpr int32_t kClipLeast_px = -32768, kClipGreatest_px = 32767;  // of a clip's sides

// How the texture lies in memory when it is drawn from.
enum class Layout : int32_t {
  kGiven,   // rows as the case has them
  kPadded,  // these, laid out anew by the subject: rows
  kTiled    // likewise: tiles
};
inline constexpr int32_t kLayoutCount = 3;

using Vertices = std::vector<selvage_vertex>;

struct Case {
  selvage_profile profile = SELVAGE_PROFILE_EXACT;
  selvage_format format = SELVAGE_RGBA8888;
  selvage_filter filter = SELVAGE_FILTER_NEAREST;
  selvage_address address = SELVAGE_ADDRESS_CLAMP;
  int32_t target_width_px = 16, target_height_px = 16;  // 1 .. 65536, product <= kMaxTargetPx
  int32_t texture_width_texel = 16, texture_height_texel = 16;  // likewise kMaxTextureTexels
  int32_t padding_px = 0;     // 0 .. 15: pixels between the end of a row and the next, both images
  bool flip_target = false;   // negative pitch
  bool flip_texture = false;  // negative pitch
  Layout layout = Layout::kGiven;
  bool has_clip = false;
  selvage_rect clip{};  // each side in [kClipLeast_px, kClipGreatest_px]
  uint32_t choice = 0;  // what a law may vary freely: a shift, a chord, a centre
  Vertices vertices;    // each field in its accepted range; any count

  friend bool operator==(const Case& a, const Case& b);
};

// Profile and format allow filters other than nearest.
[[nodiscard]] inline bool can_be_filtered(const Case& c) {
  return c.profile == SELVAGE_PROFILE_EXACT && c.format == SELVAGE_RGBA8888;
}

// Little-endian: 22 bytes of header, then 17 bytes a vertex (x 3, y 3, u 4, v 4, q - 1: 3).
// Missing header bytes read as zero; vertices beyond kMaxVertices and trailing bytes short of a
// vertex are ignored. decode(encode(c)) == c for every c within the ranges above and kMaxVertices.
[[nodiscard]] std::vector<uint8_t> encode(const Case& c);
[[nodiscard]] Case decode(std::span<const uint8_t> bytes);

// Lower-case hexadecimal of the encoding: the one-line form that `selvage verify --case` replays.
[[nodiscard]] std::string to_hex(const Case& c);
// Either letter case. Empty if the text has an odd length or holds anything but such digits.
[[nodiscard]] std::optional<Case> from_hex(std::string_view hex);

// A description for people, in whole lines: sizes, options, and each vertex in pixels and texels,
// exactly.
[[nodiscard]] std::string print(const Case& c);

}  // namespace selvage::spec
