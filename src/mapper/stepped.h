// Stepped rows: a row in perspective whose u and v are divided only every segment_px pixels, and go
// straight between. Every texel of it is taken from the lanes; how far they are from the exact map
// is for tolerance.h to know.
//
// All kernels, under every clip, draw the same: segments start at the row's own first pixel,
// visible or not; their ends are computed in double by the same operations, each rounded by itself;
// lanes of 16.16 are taken afresh from 32.32 at every kStepGroup_px pixels of a segment.
#pragma once

#include <cmath>
#include <cstdint>

#include "mapper/lanes.h"
#include "mapper/span.h"
#include "mapper/span_batch.h"

namespace selvage::mapper {

inline constexpr int32_t kStepGroup_px = 16;
// What was measured to cost a kernel no more than a division a pixel: rows that are so wide, of
// segments that are so long or reach all along the row.
struct Stepping {
  int32_t least_row_px, least_segment_px;  // the latter a power of two

  [[nodiscard]] constexpr int32_t shortest_px() const {
    return least_row_px < least_segment_px ? least_row_px - 1 : least_segment_px;
  }
};
inline constexpr Stepping kUsualStepping{160, 64};
inline constexpr Stepping kWideStepping{256, 1024};  // AVX-512, to which divisions cost little

inline constexpr int kStepShift = kLaneFraction - kTexelFraction;
// Floors that cost less than a unit each: of a segment's start, of a group's first lane, and of the
// steps from there.
inline constexpr int32_t kStepTruncations_fx16 = 3;
// A step is off by less than this: its own floor, and roundings in double far below a unit.
inline constexpr int64_t kStepError_fx32 = 2;
// A step fits 32 bits wherever a chord is within a tolerance: it is below 2^28 units of 2^-16
// texel. With the names of spec/README.md, 8.9, it is at most s = |du| r / n. As |du| <= 2^32 and n
// >= 159, it is below 2^28 where r <= 2. Elsewhere s <= 2^32 r / n, and s (r - 1) N^2 / (4 n) <
// 2^31: their product is s^2 < 2^65 r / (r - 1) / N^2 <= 2^66 / 64^2.

// Rows under one map, some of them stepped. Segments reach from pixel to pixel, the last one of a
// row to its last pixel.
struct SteppedSpans {
  const SpanBatch& batch;  // the pixels to be drawn: none of a row that is not stepped
  const SpanBatch& whole;  // the same rows, clipped by nothing
  const ProjectiveField& field;
  // Of each row: a multiple of kStepGroup_px, the last segment shorter, or all of the row.
  const int32_t* segment_px;
};

// Floored to 2^-32 texel; the product is by a power of two and exact.
[[nodiscard]] inline double step_fx32(double step_fx16) {
  return std::floor(step_fx16 * (1 << kStepShift));
}

inline constexpr double kStepUnit_fx16 = 1.0 / (1 << kStepShift);  // exact

// The lane of a segment's first pixel, and the step from each pixel to the next.
struct Segment {
  Lane start, step;
};

// The part of a segment that is to be drawn.
struct SegmentPart {
  Segment segment;
  int32_t first_px;           // of the segment
  int32_t left_px, right_px;  // of the part

  // The group that holds the part's first pixel.
  [[nodiscard]] int32_t group_px() const { return left_px - (left_px - first_px) % kStepGroup_px; }
  [[nodiscard]] Lane at(int32_t px) const {
    const int64_t steps = px - first_px;
    return {segment.start.u_fx32 + steps * segment.step.u_fx32,
            segment.start.v_fx32 + steps * segment.step.v_fx32};
  }
};

}  // namespace selvage::mapper
