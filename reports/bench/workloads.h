// What is drawn and timed. Every polygon's map is affine or projective throughout, exactly, or,
// where that is said, but for the rounding of its corners to the grid: so that mappers that only
// know such maps can be asked for the same picture.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "selvage.h"

namespace selvage::reports {

inline constexpr selvage_filter kBilinear = SELVAGE_FILTER_BILINEAR, kArea = SELVAGE_FILTER_AREA;

inline constexpr int32_t kTargetSide_px = 1024;  // where a workload asks for no other

struct Workload {
  std::string id;
  std::string title;
  std::string description;  // one sentence for the page
  int32_t target_side_px = kTargetSide_px;
  int32_t texture_side_texel = 256;
  bool perspective = false;
  std::vector<std::vector<selvage_vertex>> polygons;
  selvage_filter filter = SELVAGE_FILTER_NEAREST;
  std::string ordinary_id;  // of an adversarial item: the same shape with nothing hard about it
};

// W1 to W9. The seed moves the jittered meshes and the small squares only.
[[nodiscard]] std::vector<Workload> workloads(uint64_t seed);

// Maps of which every sample, or each third, lies on a boundary between two texels or next to one,
// each behind the same shape and slopes with the samples off the boundaries.
[[nodiscard]] std::vector<Workload> adversarial_workloads();

// One square turned by 23 degrees over half of the target: W1.
[[nodiscard]] Workload half_covering_square(int32_t texture_side_texel);

}  // namespace selvage::reports
