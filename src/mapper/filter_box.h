// The texel stage of the area filter: the exact mean of a box of the texture.
#pragma once

#include <array>
#include <cstdint>

#include "mapper/filter_point.h"
#include "mapper/footprint.h"
#include "selvage.h"

namespace selvage::mapper {

// Columns [left, left + width) and rows [top, top + height), 1/256 texel; sides as of BoxSides.
struct Box {
  int32_t left_fx8, top_fx8, width_fx8, height_fx8;

  // Around the point. With the least sides its texels and weights are the bilinear ones.
  [[nodiscard]] static Box around(FilterPoint point, BoxSides sides) {
    return {point.u_fx8 - ((sides.u_fx8 - kTexel_fx8) >> 1),
            point.v_fx8 - ((sides.v_fx8 - kTexel_fx8) >> 1), sides.u_fx8, sides.v_fx8};
  }
};

// The four channels summed over a box, each texel of the plane as often as it is covered in
// (1/256 texel)^2. What is beyond the texture is counted, not visited: time is proportional to the
// texels of the texture under the box, and constant where the texture has sums.
using BoxSum = std::array<uint64_t, 4>;
[[nodiscard]] BoxSum box_sum(const selvage_texture& texture, selvage_address address,
                             const Box& box);
// 255 * area, twice, and the area.
static_assert(uint64_t{255 * 2 + 1} <= UINT64_MAX / kMostSide_fx8 / kMostSide_fx8);

// The mean, halves rounded up.
[[nodiscard]] uint32_t box_mean(const selvage_texture& texture, selvage_address address,
                                const Box& box);
[[nodiscard]] uint32_t box_mean(const BoxSum& sum, const Box& box);

}  // namespace selvage::mapper
