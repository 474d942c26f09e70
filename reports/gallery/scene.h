// A scene of the gallery: polygons over a plain background, each with its picture.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "cli/raster.h"
#include "selvage.h"

namespace selvage::reports {

struct Polygon {
  std::vector<selvage_vertex> vertices;
  const cli::Raster* picture = nullptr;
  selvage_address address = SELVAGE_ADDRESS_CLAMP;
};

struct Scene {
  std::string id, title;
  std::string sentence;  // what to see in it
  int32_t width_px = 480, height_px = 300;
  cli::Colour background{24, 28, 38, 255};
  std::vector<Polygon> polygons;
};

}  // namespace selvage::reports
