#include <algorithm>
#include <cmath>

#include "reports/bench/curves.h"
#include "reports/bench/outlines.h"

namespace selvage::reports {

namespace {

constexpr int32_t kWideTarget_px = 1536;  // holds a turned square of 1024 px
constexpr double kSpread_px[2] = {0.7548776662,
                                  0.5698402910};  // multiples fill [0, 1) x [0, 1) evenly
constexpr int32_t kMostCovered_px = 1 << 18, kMostSquares = 4096;

// As many squares as cover 2^18 px together, 1 at least and 4096 at most, evenly over the target,
// each at another place between the pixels. Their pitch is 3 sides where there are several; a
// turned square is 1.31 sides wide.
Workload squares_of(double area_px) {
  Workload load;
  const double side_px = std::sqrt(area_px);
  const int count = std::clamp(static_cast<int>(kMostCovered_px / area_px), 1, kMostSquares);
  const int across = static_cast<int>(std::ceil(std::sqrt(count)));
  const double pitch_px = static_cast<double>(kWideTarget_px) / across;
  for (int i = 0; i < count; ++i) {
    const double x_px = (i % across + 0.5) * pitch_px + std::fmod(i * kSpread_px[0], 1.0);
    const double y_px = (i / across + 0.5) * pitch_px + std::fmod(i * kSpread_px[1], 1.0);
    load.polygons.push_back(turned_square(x_px, y_px, side_px, std::min(side_px, 256.0)));
  }
  load.target_side_px = kWideTarget_px;
  return load;
}

}  // namespace

Curve curve_polygon_size() {
  Curve curve;
  curve.id = "polygon-size";
  curve.title = "Cost against polygon size";
  curve.description =
      "squares turned by 23 degrees, a texel a pixel up to 256 x 256, a call a square, but of "
      "exact-many one call for all: as many as cover 2^18 pixels together, but 4096 at most";
  curve.axis = "size of a polygon, px";
  for (double area_px = 1; area_px <= 1 << 20; area_px *= 4) curve.xs.push_back(area_px);
  curve.load_at = squares_of;
  curve.series = usual_series();
  curve.series.push_back({"exact-many", [](double) { return subject_exact_many(1); }});
  return curve;
}

}  // namespace selvage::reports
