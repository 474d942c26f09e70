// Which kernel SELVAGE_KERNEL_FASTEST is: a table that was measured.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "mapper/polygon.h"
#include "selvage.h"

namespace selvage::mapper {

inline constexpr size_t kWorks = 3;  // kinds of selvage_work

// Every kernel but SELVAGE_KERNEL_FASTEST, the fastest first. The scalar one runs everywhere: what
// follows it is slower.
using KernelOrder = std::array<selvage_kernel, 5>;

[[nodiscard]] const KernelOrder& kernel_order(selvage_filter filter, selvage_work work);

// Polygons of a mesh are up to so wide.
inline constexpr int32_t kNarrow_px = 32;

// What drawing a polygon is like: within a tolerance, perspective is as affine maps are.
[[nodiscard]] inline selvage_work work_of(const Polygon& polygon, int32_t tolerance) {
  if (!polygon.affine && tolerance == 0) return SELVAGE_WORK_PERSPECTIVE;
  return polygon.right_px - polygon.left_px > kNarrow_px ? SELVAGE_WORK_LARGE : SELVAGE_WORK_MESH;
}

}  // namespace selvage::mapper
