#include "reports/stability/arithmetic_dda.h"

namespace selvage::stability {

Arithmetic float32_dda() {
  return {"float32-dda",
          "float, 24 bits: x, u/w, v/w, 1/w stepped down the edges and along the span, prestepped; "
          "a division a pixel; floor",
          false, draw_dda<float>};
}

}  // namespace selvage::stability
