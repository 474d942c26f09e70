// What the historic mappers ask of a polygon beyond what every mapper does.
#pragma once

#include "mapper/polygon.h"
#include "selvage.h"

namespace selvage::historic {

// SELVAGE_OK, or the first of SELVAGE_ERROR_VERTEX_FRACTION and SELVAGE_ERROR_VERTEX_Q_DIFFERS that
// applies to a polygon which has passed mapper::examine.
[[nodiscard]] inline selvage_status check_whole_px(const mapper::Polygon& polygon) {
  for (const selvage_vertex& v : polygon.vertices) {
    if (v.x % SELVAGE_SUBPIXELS != 0 || v.y % SELVAGE_SUBPIXELS != 0) {
      return SELVAGE_ERROR_VERTEX_FRACTION;
    }
  }
  return polygon.affine ? SELVAGE_OK : SELVAGE_ERROR_VERTEX_Q_DIFFERS;
}

// Of a position that has passed the check.
[[nodiscard]] inline int32_t whole_px(int32_t position_fx8) {
  return position_fx8 / SELVAGE_SUBPIXELS;
}

}  // namespace selvage::historic
