// The whole number nearest to what tests compute by doubles.
#pragma once

#include <cmath>
#include <cstdint>

namespace selvage::mapper {

[[nodiscard]] inline int32_t rounded(double value) {
  return static_cast<int32_t>(std::lround(value));
}

}  // namespace selvage::mapper
