// The vector kernels' limits, and where their tables are.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

#include "mapper/image.h"
#include "mapper/kernel.h"
#include "mapper/layout.h"
#include "mapper/number.h"
#include "mapper/projective_box.h"
#include "mapper/small_polygons.h"
#include "mapper/stepped.h"

namespace selvage::mapper {

// What lanes of 16.16 lose beside the margin of 32.32 ones: less than a unit by the floor of the
// anchor, and by that of the step from there.
inline constexpr int32_t kVectorTruncations_fx16 = 2;

// Counted from the first texel of a window they may be coarse: of 16 bits, the highest ones a
// texel, sums of an anchor's floor and an offset's. How far the beginning of the value's texel may
// lie above such a lane, in whole units as both are, where the sum of the two lacks less than
// lack_fx16. Capped at a texel: that much tells of a near-tie wherever a lane is.
inline constexpr int kCoarseBits = 16, kMostCoarseTexelBits = 4;
inline constexpr int32_t kCoarseTruncations = 2;
[[nodiscard]] constexpr int32_t coarse_lack(int texel_bits, int32_t lack_fx16) {
  const int32_t dropped_fx16 = (1 << texel_bits) - 1;
  const int32_t lack = (kCoarseTruncations * dropped_fx16 + lack_fx16 - 1) >> texel_bits;
  return std::min<int32_t>(lack, 1 << (kCoarseBits - texel_bits));
}
static_assert(kCoarseBits == kTexelFraction);  // so that a unit is 2^texel_bits fx16

// Counted from the first texel of a window they may be finer, too, of the same law and for fewer
// texels: 8.24. The filters over four texels ask for that.
inline constexpr int kWindowFraction = 24;
inline constexpr int kWindowShift = kLaneFraction - kWindowFraction;
inline constexpr int32_t kVectorTruncations_fx24 = kVectorTruncations_fx16;

// What a true value is above such a lane, at most. In the rows of one window they walk from a pixel
// to each anchor by so many floors of steps in 8.24, of which each loses less than a unit
// (spec/proofs/fine_lanes.g); elsewhere by none (spec/proofs/vector_lanes.g).
[[nodiscard]] constexpr int32_t fine_lack_fx24(int32_t steps, uint32_t margin_fx32) {
  return kVectorTruncations_fx24 + steps + static_cast<int32_t>(margin_fx32 >> kWindowShift) + 1;
}

// Small polygons of AVX-512 and AVX2. In double, all sums and products of their whole numbers are
// exact: those of changes in x, y, u and v from vertex to vertex, and of these by the way from a
// vertex to a pixel, or to a lane of its vector that is none.
inline constexpr SmallLimits kSmall = {kMostLanes, 64, 64, 4};
static_assert(kSmall.most_px < kUsualStepping.least_row_px, "a tolerance changes none of them");
inline constexpr int kSmallPlaceBits = 13, kSmallTexelBits = kTexelFraction + 6;
static_assert((kSmall.most_px + 1) << kSubpixelBits <= 1 << kSmallPlaceBits &&
              kSmall.most_columns_texel << kTexelFraction <= 1 << kSmallTexelBits &&
              kSmall.most_rows_texel << kTexelFraction <= 1 << kSmallTexelBits);
static_assert(2 * (kSmallPlaceBits + 1) + kSmallTexelBits + 2 < 53);

// Their lanes walk right and down from the first pixel.
inline constexpr int32_t kMostSmallSteps = 2 * kSmall.most_px;
inline constexpr int32_t kSmallLack_fx24 =
    fine_lack_fx24(kMostSmallSteps, uint32_t{kMostSmallSteps + 1} * kPlaneErrorPerStep_fx32);

// In perspective they are truncated quotients of single precision, of forms that are affine over
// the 16 x 16 pixels, lowered by their error: so many roundings of the most that u's form, or v's,
// can be there, times the most that q's can be over the least q of the vertices
// (spec/proofs/small_projective.g).
inline constexpr double kSmallQuotientRoundings = 11.26;  // in units of 2^-24
inline constexpr double kSmallRoundings = kSmallQuotientRoundings + 1.04;
inline constexpr double kSmallSlack_fx24 = 0.35;
inline constexpr int32_t kSmallTruncations_fx24 = 2;
inline constexpr double kMostSmallError_fx24 = 1 << 19, kMostSmallDepth = 1 << 10;
static_assert(2 * kMostSmallError_fx24 + kSmallTruncations_fx24 < 1 << (kWindowFraction - 3));

// The forms are made in double. q's is exact, u's off by so much, in units of 2^-16 texel times the
// greatest q and over the doubled area (spec/proofs/small_forms.g): enough to find a texel but next
// to a boundary, where the low 64 bits of integers are; and for lanes, if there is some area.
inline constexpr int kSmallAreaBits = 25;
static_assert(((kSmall.most_px + 1) << kSubpixelBits) * ((kSmall.most_px + 1) << kSubpixelBits) <=
              1 << kSmallAreaBits);
inline constexpr double kSmallForm = 0.41;
inline constexpr int32_t kLeastSmallArea = 1 << 11;
inline constexpr double kSmallForms_fx24 =
    kSmallForm * (1 << (kWindowFraction - kTexelFraction)) * kSmall.most_q_ratio / kLeastSmallArea;
inline constexpr int kNearSmallBits = 6;  // no further than 2^-kNearSmallBits texel
static_assert(kSmallForm * kSmall.most_q_ratio < 1 << (kTexelFraction - kNearSmallBits - 1));
static_assert(kSmallAreaBits + kQBits + kTexelFraction - kNearSmallBits + 1 < 63);

// In perspective they are floors of estimates that are lowered by their error, and lack less than
// twice that, the floor's unit, and what is left of one where the sum is floored.
inline constexpr int32_t kDividedTruncations_fx16 = 2;
inline constexpr int32_t kDividedTruncations_fx24 = kDividedTruncations_fx16;

// Or they are counted from an anchor, the first of a vector of pixels, in single precision: where
// the denominator turns by no more than half of itself over them, and u and v walk no further than
// so. Anchors are lowered by twice their error, a half for the rounding to a whole number, and the
// roundings of single precision; kAnchoredTruncations_fx16 is for floors.
inline constexpr double kMostTurn = 0.5, kMostWalk_fx16 = (1 << 22) - 4;
inline constexpr float kWholeNumbers = 3 << 22;     // floats next to it, up to 2^22 away, are whole
inline constexpr double kAnchoredRoundings = 6.25;  // in units of 2^-24 of the walk
inline constexpr double kAnchoredSlack_fx16 = 0.5 + 0x1p-10;
inline constexpr int32_t kAnchoredTruncations_fx16 = 2;

// In units of 2^-16 texel.
[[nodiscard]] constexpr double anchored_error_fx16(double error_fx16, double walk_fx16) {
  return 2 * error_fx16 + kAnchoredRoundings * 0x1p-24 * walk_fx16 + kAnchoredSlack_fx16;
}
inline constexpr double kFx16PerFx32 = 1.0 / (1 << (kLaneFraction - kTexelFraction));
[[nodiscard]] inline double walk_fx16(const ProjectiveField& field) {
  return (kMostLanes - 1) * field.steepest_fx32 * kFx16PerFx32;
}
[[nodiscard]] inline bool are_anchored(const ProjectiveField& field) {
  return (kMostLanes - 1) * field.turn <= kMostTurn && walk_fx16(field) <= kMostWalk_fx16;
}
[[nodiscard]] inline double anchored_error_fx16(const ProjectiveField& field) {
  return anchored_error_fx16(static_cast<double>(field.error_fx32) * kFx16PerFx32,
                             walk_fx16(field));
}
// Their near-ties are no further from the whole number than 2^-kLeastSpareBits.
inline constexpr double kMostAnchoredError_fx16 =
    anchored_error_fx16((kMostReach + kProjectiveTruncations_fx32) * kFx16PerFx32, kMostWalk_fx16);
inline constexpr int kLeastSpareBits = 12;
static_assert(2 * kMostAnchoredError_fx16 + kAnchoredTruncations_fx16 <=
              1 << (kTexelFraction - kLeastSpareBits));

// In pairs of rows anchors are this far apart, and one may lie beyond its row's ends, where the
// denominator may be half the least one of the field: errors are twice as large there. Less than a
// vector beside the box it is above 0 still, and u and v rise or fall all the way. Walks are added
// to lanes of the anchor that are counted from a window of kMostLanes columns, which must be whole
// next to kWholeNumbers, too. And no anchor that a pixel is counted from is beyond 16.16, as others
// may be.
inline constexpr int32_t kPairAnchor_px = 4 * kMostLanes;
inline constexpr double kLeastPairDenominator = 0.5;
inline constexpr double kMostPairWalk_fx16 = kMostWalk_fx16 - (kMostLanes << kTexelFraction) - 64;
inline constexpr int32_t kMostPairTexture_texel = 1 << 14;

[[nodiscard]] inline double pair_walk_fx16(const ProjectiveBox& box) {
  return (kPairAnchor_px - 1) * box.steepest_fx32 * kFx16PerFx32;
}
[[nodiscard]] inline bool are_pairs_anchored(const ProjectiveBox& box) {
  return box.least_denominator >= kLeastPairDenominator &&
         (kPairAnchor_px - 1) * box.turn <= kMostTurn && pair_walk_fx16(box) <= kMostPairWalk_fx16;
}
[[nodiscard]] inline double pair_error_fx16(const ProjectiveField& field,
                                            const ProjectiveBox& box) {
  return anchored_error_fx16(
      static_cast<double>(field.error_fx32) * (kFx16PerFx32 / kLeastPairDenominator),
      pair_walk_fx16(box));
}
static_assert(2 * anchored_error_fx16((kMostReach + kProjectiveTruncations_fx32) *
                                          (kFx16PerFx32 / kLeastPairDenominator),
                                      kMostPairWalk_fx16) +
                  kAnchoredTruncations_fx16 <=
              1 << (kTexelFraction - kLeastSpareBits));

// 16.16 lanes fit 32 bits although they may be low by a little.
[[nodiscard]] inline bool lanes_fit(const Polygon& polygon) {
  return std::min(polygon.texels.least_u_fx16, polygon.texels.least_v_fx16) >=
         INT32_MIN + (1 << kTexelFraction);
}

// And so do places in the texture, in texels from its first.
[[nodiscard]] inline bool places_fit(const selvage_texture& texture) {
  constexpr int64_t kMost = INT32_MAX;
  const int64_t pitch_texel = pitch_texel_of(texture);
  const int64_t stride_texel = pitch_texel < 0 ? -pitch_texel : pitch_texel;
  return stride_texel <= kMost && stride_texel * rows_of_bytes(texture).rows <= kMost;
}

// Texels of larger textures are asked for ahead of their fetch. That costs up to half as much again
// where a cache holds them, and saves half where memory has to answer, as it mostly has to: caches
// of today hold little more, and others want their share.
inline constexpr int64_t kCached_bytes = 8 << 20;

[[nodiscard]] inline bool is_cached(const selvage_texture& texture) {
  return int64_t{texture.width} * texture.height * bytes_per_pixel(texture.format) <= kCached_bytes;
}

// Whether a gather was faster than a load for each texel of a vector: by AVX-512, on AMD's families
// 25 and 26, where it saved up to a fifth and a quarter. No others were measured.
[[nodiscard]] bool were_gathers_faster();
// Whether kernels gather: the same. A weak symbol, so that a test links the other answer.
[[nodiscard]] bool are_gathers_fast();

// NULL where the build or the machine has no such kernel.
[[nodiscard]] const Kernels* vector_kernels(selvage_kernel kernel, selvage_filter filter);
// Those of the first one in an order that they have, before the scalar one; else NULL.
[[nodiscard]] const Kernels* first_vector_kernels(std::span<const selvage_kernel> order,
                                                  selvage_filter filter);

}  // namespace selvage::mapper
