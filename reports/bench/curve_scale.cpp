#include "reports/bench/curves.h"
#include "reports/bench/outlines.h"

namespace selvage::reports {

Curve curve_scale() {
  constexpr double side_px = 256;
  constexpr int32_t texture_texel = 4096;
  Curve curve;
  curve.id = "scale";
  curve.title = "Cost against scale";
  curve.description =
      "a square of 256 px turned by 23 degrees, with 16 to 4096 texels of a texture of 4096 x 4096 "
      "along its sides";
  curve.axis = "texels a pixel, each way";
  for (double scale = 1.0 / 16; scale <= 16; scale *= 2) curve.xs.push_back(scale);
  curve.load_at = [](double scale) {
    Workload load;
    load.target_side_px = 512;
    load.texture_side_texel = texture_texel;
    load.polygons = {turned_square(256.37, 256.37, side_px, side_px * scale)};
    return load;
  };
  curve.series = usual_series();
  return curve;
}

}  // namespace selvage::reports
