// What exactness is weighed against: vector loops of the mapper's kind that take roundings as they
// come. Gradients once a polygon, lanes of 16.16 along a row, in perspective of single precision
// with a division a pixel, clamped addresses; no near-tie is looked for.
#pragma once

#include <string>
#include <vector>

#include "reports/bench/image.h"
#include "reports/bench/inexact_polygon.h"

namespace selvage::reports {

struct InexactLoop {
  std::string name;  // the target, and what texels are fetched by
  void (*draw)(const InexactPolygon& polygon, const Texture& texture, Target& target);
};

// Those that this machine can run; none without Highway. All draw the same pixels.
[[nodiscard]] std::vector<InexactLoop> inexact_loops();

}  // namespace selvage::reports
