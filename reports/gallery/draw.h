// A scene drawn by the mapper and by the exact model, and what differs.
#pragma once

#include <cstdint>

#include "cli/raster.h"
#include "reports/gallery/scene.h"

namespace selvage::reports {

// Throws std::runtime_error with the polygon's number where the mapper refuses one.
[[nodiscard]] cli::Raster draw_by_mapper(const Scene& scene);

struct ModelDrawing {
  cli::Raster picture;
  std::vector<uint8_t> covers;  // how many polygons cover each pixel, at most 255
};

[[nodiscard]] ModelDrawing draw_by_model(const Scene& scene);

struct Difference {
  cli::Raster map;  // dark: nothing drawn; grey: drawn and equal; red: different
  uint64_t differing_px = 0, covered_px = 0, covered_twice_px = 0;
};

[[nodiscard]] Difference compare(const cli::Raster& drawn, const ModelDrawing& model);

}  // namespace selvage::reports
