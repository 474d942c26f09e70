// OpenCV as an oracle: warpAffine and warpPerspective, nearest, where their arithmetic is decided.
#pragma once

#include <cstdint>
#include <string>

#include "spec/laws.h"

namespace selvage::spec {

struct OracleTally {
  uint64_t decided_px = 0;    // pixels on which OpenCV's own rounding cannot change the texel
  uint64_t undecided_px = 0;  // covered pixels on which it could
  std::optional<Violation> violation{};
};

// Draws the triangle of the case's first three vertices, and lets OpenCV draw the same map.
// Judges nothing if there is no such triangle, it has no area, or an image is too large for OpenCV.
[[nodiscard]] OracleTally ask_opencv(const Subject& subject, const Case& c);

// OpenCV's build information: version, and what it was built with.
[[nodiscard]] std::string opencv_build();

}  // namespace selvage::spec
