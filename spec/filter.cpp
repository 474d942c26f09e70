#include "spec/filter.h"

#include <algorithm>
#include <map>

namespace selvage::spec {
namespace {

[[nodiscard]] Rational half() { return {1, 2}; }

// The texels under [begin, begin + side), 1/256 texel, weighed by how much of them it covers.
[[nodiscard]] Taps under(int64_t begin_fx8, int64_t side_fx8) {
  const int64_t end_fx8 = begin_fx8 + side_fx8;
  Taps taps;
  for (int64_t at_fx8 = begin_fx8; at_fx8 < end_fx8;) {
    const int64_t texel = at_fx8 >> 8;
    const int64_t next_fx8 = std::min(end_fx8, (texel + 1) * 256);
    taps.push_back({static_cast<int32_t>(texel), next_fx8 - at_fx8});
    at_fx8 = next_fx8;
  }
  return taps;
}

}  // namespace

int32_t box_side_fx8(const Rational& scale_texel) {
  const Rational side = 256 * scale_texel;
  if (side >= kMostBoxSide_fx8) return kMostBoxSide_fx8;
  return std::max(-floor(-side), kLeastBoxSide_fx8);  // -floor(-x) = ceil(x)
}

BoxSides box_sides(const Gradient& g) {
  return {box_side_fx8(abs(g.u_along_x) + abs(g.u_along_y)),
          box_side_fx8(abs(g.v_along_x) + abs(g.v_along_y))};
}

Taps taps(selvage_filter filter, const Rational& coordinate, int32_t side_fx8) {
  const int32_t point_fx8 = floor(256 * (coordinate - half()));
  const int32_t texel = point_fx8 >> 8, weight = point_fx8 & 255;
  switch (filter) {
    case SELVAGE_FILTER_NEAREST:
      return {{floor(coordinate), 1}};
    case SELVAGE_FILTER_FOUR:
      return {{texel, 1}, {texel + 1, 1}};
    case SELVAGE_FILTER_BILINEAR:
      if (weight == 0) return {{texel, 256}};
      return {{texel, 256 - weight}, {texel + 1, weight}};
    default:
      return under(point_fx8 - (side_fx8 - kLeastBoxSide_fx8) / 2, side_fx8);
  }
}

Taps addressed(const Taps& taps, int32_t size, selvage_address address) {
  std::map<int32_t, int64_t> weights;
  for (const auto& [texel, weight] : taps) weights[address_texel(texel, size, address)] += weight;
  Taps result;
  for (const auto& [texel, weight] : weights) result.push_back({texel, weight});
  return result;
}

uint32_t weighted_mean(const Taps& columns, const Taps& rows, const TexelAt& texel_at) {
  int64_t sums[4] = {}, total = 0;
  for (const Tap& row : rows) {
    for (const Tap& column : columns) {
      const int64_t weight = column.weight * row.weight;
      const uint32_t texel = texel_at({column.texel, row.texel});
      for (int i = 0; i < 4; ++i) sums[i] += weight * channel(texel, i);
      total += weight;
    }
  }
  uint32_t pixel = 0;
  for (int i = 0; i < 4; ++i) {
    const int64_t mean = (2 * sums[i] + total) / (2 * total);
    pixel |= in_channel(static_cast<uint32_t>(mean), i);
  }
  return pixel;
}

}  // namespace selvage::spec
