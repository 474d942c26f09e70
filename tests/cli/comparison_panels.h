// Where a picture of comparison has the pixels of a target of 8 x 8.
#pragma once

#include <cstdint>

#include "cli/raster.h"

namespace selvage::cli::test {

inline constexpr int32_t kSide_px = 8;      // of the target
inline constexpr int32_t kScale_px = 32;    // of the picture for one of the target
inline constexpr int32_t kGap_px = 8;       // around the panels
inline constexpr int32_t kCaption_px = 18;  // above each
enum Panel { kDrawn, kExpected, kDifference };

// The picture's colour `d` px right of and below the corner of the target's pixel (x, y); 16 is its
// middle, 0 its frame.
[[nodiscard]] inline Colour colour_at(const Raster& picture, Panel panel, int32_t x, int32_t y,
                                      int32_t d = 16) {
  return picture.at(kGap_px + panel * (kSide_px * kScale_px + kGap_px) + x * kScale_px + d,
                    kGap_px + kCaption_px + y * kScale_px + d);
}

}  // namespace selvage::cli::test
