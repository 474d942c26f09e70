#include <cmath>

#include "reports/bench/curves.h"
#include "reports/bench/outlines.h"

namespace selvage::reports {

Curve curve_off_screen() {
  constexpr double target_px = 1024;
  Curve curve;
  curve.id = "off-screen";
  curve.title = "Cost against off-screen share";
  curve.description =
      "a square turned by 23 degrees about the middle of a target that it covers whole, of 2 to "
      "400 "
      "times its area, 256 x 256 texels on it: W6 is at 100";
  curve.axis = "area of the polygon / visible area (100: 99 % off screen)";
  for (const double ratio : {1.0, 2.0, 4.0, 10.0, 20.0, 40.0, 100.0, 200.0, 400.0})
    curve.xs.push_back(ratio);
  curve.load_at = [](double ratio) {
    if (ratio == 1) return half_covering_square(256);
    Workload load;
    load.polygons = {turned_square(target_px / 2 + 0.37, target_px / 2 + 0.37,
                                   target_px * std::sqrt(ratio), 256)};
    return load;
  };
  curve.series = usual_series();
  return curve;
}

}  // namespace selvage::reports
