// The lanes of a plane: gradients that are divided once a polygon, for all of its spans.
#pragma once

#include <cstdint>

#include "mapper/lanes.h"
#include "mapper/plane_frame.h"

namespace selvage::mapper {

// Estimates of gradients in double, up to 2^52 units, are off by a few units at most.
inline constexpr double kMostPlaneEstimate_fx32 = 0x1p52;
inline constexpr int kPlaneEstimateError_fx32 = 6;
// Sums of two products up to here are exact in double. Quotients up to there, made whole by what
// rounds them to their last bits, are off by less than 1 (spec/proofs/plane_quotient.g).
inline constexpr double kMostExactProduct = 0x1p52;
inline constexpr double kMostRounded_fx32 = 0x1p50;
inline constexpr double kRoundToWhole = 0x1.8p52;
inline constexpr double kRoundedError_fx32 = 0.75;
static_assert(kRoundedError_fx32 < 1, "the sign of a remainder makes the floor");
// A lane is low by less than so many units for the start and for each step from it.
inline constexpr uint32_t kPlaneErrorPerStep_fx32 = 1;

// In fx32, a step of a pixel is 2^kPlaneStepShift A / D, and the start is 2^kPlaneStartShift (dx A
// + dy B) / D above the origin's.
inline constexpr int kPlaneStartShift = kLaneFraction - kTexelFraction;
inline constexpr int kPlaneStepShift = kPlaneStartShift + kSubpixelBits;

// From the frame's origin to the centre of the lanes' first pixel, in 1/256 px.
struct WayToStart {
  int64_t dx_fx8, dy_fx8;

  WayToStart(const PlaneFrame& frame, const AffineField& lanes)
      : dx_fx8(centre_fx8(lanes.first_px) - int64_t{frame.origin().x}),
        dy_fx8(centre_fx8(lanes.first_row) - int64_t{frame.origin().y}) {}
};

// Sets the start and the steps of lanes of which the first pixel is set: floors, the same by
// whichever function sets them. The frame has an area. False, maybe not by each of them, where
// gradients are so steep that 64 bits may not hold them.
using FindLanes = bool (*)(const PlaneFrame& frame, AffineField* lanes);

[[nodiscard]] bool find_lanes_scalar(const PlaneFrame& frame, AffineField* lanes);

}  // namespace selvage::mapper
