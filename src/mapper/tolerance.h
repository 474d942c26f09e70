// Tolerance: what a row in perspective is drawn by, where its texels need not be exact.
//
// spec/README.md derives the bounds. All that enters a choice is the polygon, the row and the
// tolerance: no clip and no machine changes what is drawn.
#pragma once

#include <cstdint>

#include "mapper/lanes.h"
#include "mapper/stepped.h"
#include "selvage.h"

namespace selvage::mapper {

// What is below a unit of the errors in 32.32 takes one unit more.
inline constexpr int32_t kStepRounding_fx16 = kStepTruncations_fx16 + 1;
// Factors that hold all roundings in double: of the ratio of two denominators, each off by less
// than 2^-26 of itself, and of a chord's bound that is computed from it; of the length that is
// chosen by that bound.
inline constexpr double kRatioSlack = 1 + 0x1p-24;
inline constexpr double kBudgetSlack = 1 - 0x1p-30;
// Narrower rows and shorter segments were measured to cost as much as a division a pixel, by some
// kernel at least.
inline constexpr int32_t kLeastStepped_px = 96;
inline constexpr int32_t kLeastSegment_px = 3 * kStepGroup_px;

// Lanes of a plane that are further off cost too much of a tolerance: 1/8 unit at their two ends.
inline constexpr int64_t kMostSteppedError_fx32 = 1 << 12;

struct RowChoice {
  selvage_method method;
  int32_t segment_px;  // of SELVAGE_METHOD_SUBDIVIDED, else 0
  int32_t bound_fx16;  // of the distance to the exact u and to the exact v
};

// The lanes are of a whole row of width_px pixels, clipped or not.
[[nodiscard]] RowChoice choose_row(const DividedLanes& lanes, int32_t width_px,
                                   int32_t tolerance_fx16);

}  // namespace selvage::mapper
