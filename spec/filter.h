// The filters: which texels a pixel is the mean of, and with which weights.
//
// Every filter takes some columns and some rows, each with a weight; a texel's weight is the
// product of its column's and its row's. The pixel is the weighted mean, channel by channel, halves
// rounded up.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "selvage.h"
#include "spec/exact.h"
#include "spec/gradient.h"

namespace selvage::spec {

// The value of a texel that has been addressed.
using TexelAt = std::function<uint32_t(Texel)>;

// A column or a row, and its weight > 0.
struct Tap {
  int32_t texel;
  int64_t weight;
  friend bool operator==(const Tap&, const Tap&) = default;
};
using Taps = std::vector<Tap>;

// The sides of the area filter's box, 1/256 texel.
inline constexpr int32_t kLeastBoxSide_fx8 = 256;
inline constexpr int32_t kMostBoxSide_fx8 = 1 << 24;
struct BoxSides {
  int32_t u_fx8 = kLeastBoxSide_fx8, v_fx8 = kLeastBoxSide_fx8;
};
// Of a footprint so many texels wide (or high): ceil(256 scale), within these ends.
[[nodiscard]] int32_t box_side_fx8(const Rational& scale_texel);
[[nodiscard]] BoxSides box_sides(const Gradient& gradient);

// Along one axis, before the address mode. The side matters to the area filter only.
[[nodiscard]] Taps taps(selvage_filter filter, const Rational& coordinate, int32_t side_fx8);

// Each texel addressed by itself; those that become the same are one.
[[nodiscard]] Taps addressed(const Taps& taps, int32_t size, selvage_address address);

// The pixel, of taps that have been addressed.
[[nodiscard]] uint32_t weighted_mean(const Taps& columns, const Taps& rows,
                                     const TexelAt& texel_at);

// One channel of a texel, 0 .. 3, and a texel that has only this channel.
[[nodiscard]] inline uint32_t channel(uint32_t texel, int index) {
  return texel >> 8 * index & 255;
}
[[nodiscard]] inline uint32_t in_channel(uint32_t value, int index) { return value << 8 * index; }

}  // namespace selvage::spec
