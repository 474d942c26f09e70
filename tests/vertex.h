// A vertex of which only place and depth matter.
#pragma once

#include <cstdint>

#include "selvage.h"

namespace selvage::mapper {

[[nodiscard]] inline selvage_vertex vertex(int32_t x_fx8, int32_t y_fx8, int32_t q = 1) {
  return {x_fx8, y_fx8, 0, 0, q};
}

}  // namespace selvage::mapper
