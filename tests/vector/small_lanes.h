// The lanes that vector kernels have for small polygons, which else only they see.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "mapper/small_polygons.h"
#include "mapper/vector/kernel.h"
#include "selvage.h"

namespace selvage::mapper {

inline constexpr size_t kMostSmall_px = size_t{kSmall.most_px};

// Of each row of a polygon's part, its first pixel from the part's left on.
using SmallBegins = std::array<int32_t, kMostSmall_px>;

struct SmallLanes {
  bool has_lanes;
  int32_t lack_fx24;
  int32_t s_texel, t_texel;  // where lanes are counted from
  // By rows of the part, from the first pixel of each on.
  std::array<std::array<int32_t, kMostSmall_px>, kMostSmall_px> u_fx24, v_fx24;
};

// Of a list: all kinds of polygons that a kernel tells apart are drawn by the same.
using FindSmallLanes = void (*)(const SmallPolygons& polygons, const selvage_texture& texture,
                                std::span<const SmallBegins> begins, std::span<SmallLanes> lanes);

struct SmallLanesOf {
  selvage_kernel kernel;
  FindSmallLanes find;
};

// By the kernels that draw small polygons and that this machine can run.
[[nodiscard]] std::vector<SmallLanesOf> all_small_lanes();

}  // namespace selvage::mapper
