// Tolerance: what a row in perspective is drawn by, where its texels need not be exact.
//
// spec/README.md derives the bounds. All that enters a choice is the polygon, the row and the
// tolerance, and what is too short for a kernel to be stepped: no clip changes what is drawn.
#pragma once

#include <cstdint>

#include "mapper/bend.h"
#include "mapper/stepped.h"
#include "selvage.h"

namespace selvage::mapper {

// What is below a unit of the errors in 32.32 takes one unit more.
inline constexpr int32_t kStepRounding_fx16 = kStepTruncations_fx16 + 1;
// Factors that hold all roundings in double, of denominators, each off by less than 2^-26 of
// itself, and of what is computed from them (spec/proofs/chord_bound.g): of how much a row bends;
// of what the tolerance leaves to that.
inline constexpr double kBendSlack = 1 + 0x1p-23;
inline constexpr double kBudgetSlack = 1 - 0x1p-30;

// Lanes of a plane that are further off cost too much of a tolerance: 1/8 unit at their two ends.
inline constexpr int64_t kMostSteppedError_fx32 = 1 << 12;

// What lanes along a row may lose, its curve apart.
[[nodiscard]] inline int32_t roundings_fx16(int64_t margin_fx32, int32_t width_px) {
  return static_cast<int32_t>((margin_fx32 + kStepError_fx32 * (width_px - 1)) >> kStepShift) +
         kStepRounding_fx16;
}

// A row's chords. How far one is off, times the cube of the row's least denominator, so that no
// division is needed to tell whether that is within a tolerance.
struct Chords {
  double one_px_fx16;  // of chords a pixel long; longer ones by the square of that
  double cube;

  explicit Chords(const RowBend& row)
      : one_px_fx16(row.slope_fx32 * row.turn * (kBendSlack / (4 << kStepShift))),
        cube(row.least_denominator * row.least_denominator * row.least_denominator) {}

  [[nodiscard]] double off_fx16(double length_px) const {
    return one_px_fx16 * length_px * length_px;
  }
  [[nodiscard]] double room_fx16(int32_t budget_fx16) const {
    return budget_fx16 * cube * kBudgetSlack;
  }
};

// Whether a row that bends so much at least, however wide it is, is exact.
[[nodiscard]] inline bool bends_too_much(const RowBend& row, int32_t tolerance_fx16,
                                         const Stepping& stepping = kUsualStepping) {
  const Chords chords(row);
  return chords.off_fx16(stepping.shortest_px()) > chords.room_fx16(tolerance_fx16);
}

// How far the segments of a stepped row reach: a multiple of kStepGroup_px, or, where one does for
// all of the row, its width. 0: the row is exact. Width and margin are those of the row's lanes,
// clipped or not.
[[nodiscard]] int32_t choose_segment_px(const RowBend& row, int64_t margin_fx32, int32_t width_px,
                                        int32_t tolerance_fx16,
                                        const Stepping& stepping = kUsualStepping);

struct RowChoice {
  selvage_method method;
  int32_t segment_px;  // of SELVAGE_METHOD_SUBDIVIDED, else 0
  int32_t bound_fx16;  // of the distance to the exact u and to the exact v
};

// The same choice, as it is told.
[[nodiscard]] RowChoice choose_row(const RowBend& row, int64_t margin_fx32, int32_t width_px,
                                   int32_t tolerance_fx16,
                                   const Stepping& stepping = kUsualStepping);

}  // namespace selvage::mapper
