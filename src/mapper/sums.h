// Sums of a texture, for the area filter: with them a box costs the same whatever its size.
//
// Entry (s, t), 0 <= s <= width and 0 <= t <= height, holds for each of the four channels the sum
// of the texels in columns [0, s) and rows [0, t), modulo 2^32. A rectangle's sum is a difference
// of entries, modulo 2^32 too: right where it is below 2^32, so for kMostSummed texels at least.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>

#include "mapper/number.h"
#include "selvage.h"

namespace selvage::mapper {

using ChannelSums = std::array<uint32_t, 4>;  // bits 0 .. 7 of a texel first
inline constexpr int64_t kMostSummed = UINT32_MAX / 255;
// Of a side of the boxes that vectors look up, 1/256 texel: at most 2 to this power.
inline constexpr int kSummedSideBits = 20;

// How a table of sums lies in memory.
struct SumsShape {
  int64_t pitch_bytes, rows;

  [[nodiscard]] static SumsShape of(const selvage_texture& texture);
  [[nodiscard]] int128 bytes() const { return int128{pitch_bytes} * rows; }
};

// Right behind the texels, where alone a texture's sums may be; NULL if it can have none. The
// texture is valid apart from `prepared`.
[[nodiscard]] const void* place_of_sums(const selvage_texture& texture);

void write_sums(const selvage_texture& texture, void* table);

// Modulo 2^32.
[[nodiscard]] inline ChannelSums difference(const ChannelSums& a, const ChannelSums& b) {
  ChannelSums difference;
  for (size_t i = 0; i < a.size(); ++i) difference[i] = a[i] - b[i];
  return difference;
}

// The table of a texture that has one.
class Sums {
 public:
  explicit Sums(const selvage_texture& texture)
      : entries_(static_cast<const char*>(texture.prepared)),
        pitch_bytes_(static_cast<ptrdiff_t>(SumsShape::of(texture).pitch_bytes)) {}

  [[nodiscard]] ChannelSums at(int32_t s, int32_t t) const {
    ChannelSums sums;
    std::memcpy(&sums, entries_ + t * pitch_bytes_ + s * ptrdiff_t{sizeof sums}, sizeof sums);
    return sums;
  }

 private:
  const char* entries_;
  ptrdiff_t pitch_bytes_;
};

}  // namespace selvage::mapper
