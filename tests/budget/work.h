// Stated workloads for counting instructions.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "selvage.h"

namespace selvage::budget {

using Triangle = std::array<selvage_vertex, 3>;

struct Work {
  std::string_view unit;  // what a budget is per: "triangle" or "px"
  std::vector<Triangle> triangles;
  int32_t target_height_px;
  selvage_filter filter;
};

inline constexpr int32_t kTargetWidth_px = 1024;
inline constexpr int32_t kTextureSide_texel = 256;

// mesh-52 and mesh-484: a jittered mesh of triangles of about so many pixels; tilted-52 and
// tilted-484: the same in perspective; affine, perspective and bilinear: 64 spans of 1024 px.
// Nothing for another name.
[[nodiscard]] std::optional<Work> work_of(std::string_view kind);

}  // namespace selvage::budget
