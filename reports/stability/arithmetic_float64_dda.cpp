#include "reports/stability/arithmetic_dda.h"

namespace selvage::stability {

Arithmetic float64_dda() {
  return {"float64-dda",
          "double, 53 bits: x, u/w, v/w, 1/w stepped down the edges and along the span, "
          "prestepped; a division a pixel; floor",
          false, draw_dda<double>};
}

}  // namespace selvage::stability
