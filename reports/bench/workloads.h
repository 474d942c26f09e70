// What is drawn and timed. Every polygon's map is affine or projective throughout, exactly: so that
// mappers that only know such maps can be asked for the same picture.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "selvage.h"

namespace selvage::reports {

// Bilinear by the formula of 1/256 weights: fu = floor(256 (u - 1/2)), texel fu >> 8, weight fu &
// 255, the sum of products + 32768, >> 16.
inline constexpr selvage_filter kBilinear = 2;

struct Workload {
  std::string id;
  std::string title;
  std::string description;  // one sentence for the page
  int32_t target_side_px = 1024;
  int32_t texture_side_texel = 256;
  bool perspective = false;
  std::vector<std::vector<selvage_vertex>> polygons;
  selvage_filter filter = SELVAGE_FILTER_NEAREST;
};

// The seed moves the jittered mesh only.
[[nodiscard]] std::vector<Workload> workloads(uint64_t seed);

}  // namespace selvage::reports
