#include "reports/bench/curves.h"

namespace selvage::reports {

Curve curve_texture_size() {
  Curve curve;
  curve.id = "texture-size";
  curve.title = "Cost against texture size";
  curve.description =
      "the square of W1, 724 px a side, with the whole of a texture of 16 x 16 up to 8192 x 8192 "
      "texels on it";
  curve.axis = "side of the texture, texels";
  for (double side = 16; side <= 8192; side *= 2) curve.xs.push_back(side);
  curve.load_at = [](double side) { return half_covering_square(static_cast<int32_t>(side)); };
  curve.series = usual_series();
  return curve;
}

}  // namespace selvage::reports
