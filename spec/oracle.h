// OpenCV as an oracle: warpAffine and warpPerspective, nearest, where their arithmetic is decided.
#pragma once

#include <cstdint>
#include <string>

#include "spec/laws.h"

namespace selvage::spec {

// OpenCV decides a texel where u is further from an integer than its arithmetic can be off. The
// bounds, which spec/proofs proves, are in units of e = 2^-53. Each entry of the matrix is
// truncated to a double, which costs 2 e of it.
//
// warpAffine rounds two terms to 1/1024 texel each; doubles lose four e of the terms' magnitudes.
inline constexpr double kAffineRounding_texel = 0x1p-10;
inline constexpr double kAffineRoundings = 4;
// Terms below this do not overflow its 32-bit sums of 1/1024 texel.
inline constexpr double kLargestSum_texel = 1 << 20;
// warpPerspective loses, with a = S_X / |W| and b = S_W / |W| the sums of the terms' magnitudes
// over the denominator, at most factor e (terms a + (|u| + 1) (terms b + quotient)).
inline constexpr double kProjectiveFactor = 4;
inline constexpr double kProjectiveTerms = 5;
inline constexpr double kProjectiveQuotient = 3;

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
