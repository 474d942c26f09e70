// Lanes count in 2^-32 texel, vertices and tolerances in 2^-16.
#pragma once

#include <cstdint>

namespace selvage::mapper {

inline constexpr int64_t kTexel_fx32 = int64_t{1} << 32;
inline constexpr double kFx32PerFx16 = 65536;

}  // namespace selvage::mapper
