// The map of a polygon as the matrix that most peers want.
#pragma once

#include <cmath>

#include "reports/bench/planes.h"
#include "reports/peers/painter.h"

namespace selvage::reports {

// Rounded to double. Throws Inexpressible where there is none.
[[nodiscard]] inline Planes map_of(const Polygon& polygon) {
  const Planes planes = planes_of(polygon);
  for (const Plane& plane : {planes.u, planes.v, planes.q}) {
    if (!std::isfinite(plane.dx) || !std::isfinite(plane.dy) || !std::isfinite(plane.origin))
      throw Inexpressible("a polygon without area has no matrix");
  }
  return planes;
}

}  // namespace selvage::reports
