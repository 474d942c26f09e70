// Which cases the target `laws` takes. The exact model is brute force: larger ones would only run
// slower, not deeper.
#pragma once

#include <cstddef>
#include <cstdint>

#include "spec/case.h"

namespace selvage::fuzz {

inline constexpr int32_t kMaxTargetPx = 1024;  // width x height
inline constexpr int64_t kMaxAreaTexels = int64_t{1}
                                          << 21;  // pixels x texels under the area filter
inline constexpr size_t kMaxVertices = 64;

[[nodiscard]] inline bool is_taken(const spec::Case& c) {
  const int64_t texels = int64_t{c.texture_width_texel} * c.texture_height_texel;
  if (c.filter == SELVAGE_FILTER_AREA &&
      texels * c.target_width_px * c.target_height_px > kMaxAreaTexels) {
    return false;
  }
  return c.target_width_px * c.target_height_px <= kMaxTargetPx &&
         c.vertices.size() <= kMaxVertices;
}

}  // namespace selvage::fuzz
