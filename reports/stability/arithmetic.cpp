#include "reports/stability/arithmetic.h"

#include <array>

namespace selvage::stability {

std::span<const Arithmetic> arithmetics() {
  static const std::array all{fixed1616(), float32_dda(), float32_plane(), float64_dda()};
  return all;
}

}  // namespace selvage::stability
