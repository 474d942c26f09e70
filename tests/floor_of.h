// The floor of a quotient of 128 bits, by a positive denominator.
#pragma once

#include <cstdint>

#include "mapper/number.h"

namespace selvage::mapper {

[[nodiscard]] inline int64_t floor_of(int128 n, int128 d) {
  return static_cast<int64_t>(n / d - (n % d < 0 ? 1 : 0));
}

}  // namespace selvage::mapper
