// The shapes that more than one picture shows.
#pragma once

#include "reports/gallery/mesh.h"

namespace selvage::reports {

struct GlobeView {
  double centre_x_px = 240, centre_y_px = 150, radius_px = 138;
  double east_degree = 0;   // longitude in the middle
  double north_degree = 0;  // latitude in the middle
  double roll_degree = 0;
  int32_t columns = 36, rows = 18;
};

// A sphere in perspective, seen from four radii, as cells of a map in plate carree projection. The
// cells of such a sphere are plane, and it is convex: those seen from the front tile its outline.
[[nodiscard]] Grid globe(const GlobeView& view, const cli::Raster& map);

struct WaveView {
  double centre_x_px = 240, centre_y_px = 150, focal_px = 440;
  double width = 4.0, height = 2.0;  // of the sheet, in units of its distance / 4
  double amplitude = 0.2;
  double pitch_degree = 40, yaw_degree = 0, roll_degree = 0;
  int32_t columns = 40, rows = 20;
};

// A sheet with waves across it, in perspective, with the whole picture on it.
[[nodiscard]] Grid wave(const WaveView& view, const cli::Raster& picture);

}  // namespace selvage::reports
