// Where the sample point of a pixel lies, in words: for whoever reads a violation.
#pragma once

#include <string>

#include "spec/case.h"
#include "spec/geometry.h"

namespace selvage::spec {

// "(0.5, 0.5)".
[[nodiscard]] std::string describe_px(Point p);

// "(0.5, 0.5) px, not in the polygon: on the edge from (0, 0.5) to (1, 0.5) ...". An edge is
// told where it is less than 1/256 px away, and the clip where it leaves the point out.
[[nodiscard]] std::string describe_sample(const Case& shown, int32_t x_px, int32_t y_px);

}  // namespace selvage::spec
