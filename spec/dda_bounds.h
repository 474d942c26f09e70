// The constants of the historic profiles' bounds; spec/proofs proves them.
#pragma once

#include "selvage.h"

namespace selvage::spec {

// Units of 1/65536 texel that one step of a truncated 16.16 walk may lose, and that taking half a
// step by a shift may add.
inline constexpr int kUlpsPerRow = 1;
inline constexpr int kUlpsPerPixel = 1;
inline constexpr int kUlpsPerPrestep = 1;

// dkit rounds the texels on both edges: half a texel, in halves.
inline constexpr int kDkitRoundingHalves = 1;

// The position error of walking in whole columns, in half pixels: e in [-below, above].
struct WholeColumnError {
  int below_halves, above_halves;
};
[[nodiscard]] constexpr WholeColumnError whole_column_error(selvage_profile profile) {
  return profile == SELVAGE_PROFILE_ABRASH56 ? WholeColumnError{2, 0} : WholeColumnError{1, 1};
}

}  // namespace selvage::spec
