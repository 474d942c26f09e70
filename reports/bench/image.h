// The pictures of the benchmark: a target, and textures that make errors seen.
#pragma once

#include <cstdint>
#include <vector>

#include "selvage.h"

namespace selvage::reports {

// One cache line of pixels. A pitch that is a power of two maps a walk down a column onto few cache
// sets, which would measure the cache and not the mapper.
inline constexpr int32_t kPadding_px = 16, kMostPadding_px = 1024;

struct Target {
  int32_t width_px = 0, height_px = 0;
  int32_t pitch_px = 0;          // from row to row: the width and its padding, which nobody draws
  std::vector<uint32_t> pixels;  // row by row, RGBA8888, the last row padded, too

  Target(int32_t width, int32_t height, int32_t padding = kPadding_px);
  [[nodiscard]] uint32_t* row(int32_t y_px);
  [[nodiscard]] const uint32_t* row(int32_t y_px) const;
  [[nodiscard]] selvage_image image();
};

// Nearest: texels tell their own place. Filtered: noise, for on a smooth picture filters that are
// coarse are right too.
enum class Texels { kPlaces, kNoise };

[[nodiscard]] constexpr Texels texels_for(selvage_filter filter) {
  return filter == SELVAGE_FILTER_NEAREST ? Texels::kPlaces : Texels::kNoise;
}

// Square, a power of two a side. Rows are padded by a cache line, as a target's are.
struct Texture {
  int32_t side_texel = 0;
  int32_t pitch_texel = 0;
  std::vector<uint32_t> texels;

  explicit Texture(int32_t side, Texels kind = Texels::kPlaces);
  [[nodiscard]] selvage_texture view() const;
};

// Texel (s, t) of a texture of places: s in the low half, t in the high half.
[[nodiscard]] constexpr uint32_t place_of(int32_t s, int32_t t) {
  return static_cast<uint32_t>(s) | static_cast<uint32_t>(t) << 16;
}

[[nodiscard]] constexpr int32_t column_of(uint32_t place) {
  return static_cast<int32_t>(place & 0xFFFF);
}
[[nodiscard]] constexpr int32_t row_of(uint32_t place) { return static_cast<int32_t>(place >> 16); }

// Texel (s, t) of a texture of noise: opaque, each colour a level of 0 .. 254 by itself.
[[nodiscard]] uint32_t noise_of(int32_t s, int32_t t);

[[nodiscard]] uint32_t texel_of(Texels kind, int32_t s, int32_t t);

// No place in a texture below 65536 a side, no noise, and no mixture of noise.
inline constexpr uint32_t kUntouched = 0xFFFFFFFFu;

}  // namespace selvage::reports
