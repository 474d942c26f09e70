// Which kernel SELVAGE_KERNEL_FASTEST is: a table that was measured.
#pragma once

#include <array>
#include <cstdint>

#include "mapper/polygon.h"
#include "selvage.h"

namespace selvage::mapper {

// Every kernel but SELVAGE_KERNEL_FASTEST, the fastest first. The scalar one runs everywhere: what
// follows it is slower.
using KernelOrder = std::array<selvage_kernel, 5>;

[[nodiscard]] const KernelOrder& kernel_order(selvage_filter filter, selvage_work work);

// What drawing a polygon is like: within a tolerance, perspective is as affine maps are.
[[nodiscard]] selvage_work work_of(const Polygon& polygon, int32_t tolerance);

}  // namespace selvage::mapper
