#include "mapper/small_polygons.h"

#include <cstdint>

namespace selvage::mapper {

bool SmallPolygons::is_parallelogram(const Polygon& polygon) {
  if (polygon.vertices.size() != 4 || !polygon.affine || polygon.untransformed) return false;
  const auto& of = polygon.vertices;
  const auto closes = [&](int32_t selvage_vertex::*coordinate) {
    return int64_t{of[0].*coordinate} + of[2].*coordinate ==
           int64_t{of[1].*coordinate} + of[3].*coordinate;
  };
  return closes(&selvage_vertex::x) && closes(&selvage_vertex::y) && closes(&selvage_vertex::u) &&
         closes(&selvage_vertex::v);
}

}  // namespace selvage::mapper
