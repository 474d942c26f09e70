// What vectors are given to draw, and what their lanes are lowered by: the limits that the proofs
// assume (spec/proofs/anchored_lanes.g, coarse_lanes.g), met and passed by as little as can be.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "mapper/vector/kernel.h"
#include "tests/kernel_support.h"
#include "tests/lane_units.h"

namespace selvage::mapper {
namespace {

// A vector of the most lanes walks so many steps.
inline constexpr double kSteps = 15;
// And four of them, from one anchor.
inline constexpr double kPairSteps = 63;

[[nodiscard]] ProjectiveField field_of(double turn, double walk_fx16, int64_t error_fx32 = 3) {
  ProjectiveField field{};
  field.error_fx32 = error_fx32;
  field.turn = turn;
  field.steepest_fx32 = walk_fx16 * kFx32PerFx16 / kSteps;
  return field;
}

TEST(VectorLimits, AnchorsTurnByHalfAndWalkAsFarAsFloatsAreWholeAtMost) {
  const double most_turn = kMostTurn / kSteps, beyond = 1 + 0x1p-40;
  EXPECT_TRUE(are_anchored(field_of(most_turn, kMostWalk_fx16)));
  EXPECT_FALSE(are_anchored(field_of(most_turn * beyond, 1)));
  EXPECT_FALSE(are_anchored(field_of(0, kMostWalk_fx16 * beyond)));
  EXPECT_FALSE(are_anchored(field_of(HUGE_VAL, 1)));
  EXPECT_FALSE(are_anchored(field_of(0, HUGE_VAL)));
  EXPECT_TRUE(are_anchored(field_of(0, 0)));
}

TEST(VectorLimits, AnchorsAreLoweredByTheProofsBound) {
  for (const int64_t error_fx32 : {2, 3, 65538}) {
    for (const double walk_fx16 : {0.0, 1.0, 65536.0, kMostWalk_fx16}) {
      const double anchor_fx16 = 2.0 * static_cast<double>(error_fx32) / kFx32PerFx16;
      const double wanted =
          anchor_fx16 + kAnchoredRoundings * walk_fx16 / 16777216 + kAnchoredSlack_fx16;
      EXPECT_DOUBLE_EQ(anchored_error_fx16(field_of(0, walk_fx16, error_fx32)), wanted);
    }
  }
}

[[nodiscard]] ProjectiveBox box_of(double least_denominator, double turn, double walk_fx16) {
  ProjectiveBox box(field_of(0, 0), one_span({0, 0, 1}));
  box.least_denominator = least_denominator;
  box.turn = turn;
  box.steepest_fx32 = walk_fx16 * kFx32PerFx16 / kPairSteps;
  return box;
}

TEST(VectorLimits, PairsAreAnchoredWhereDenominatorsAreHalfAndWalksLeaveRoomForAWindow) {
  const double most_turn = kMostTurn / kPairSteps, beyond = 1 + 0x1p-40;
  const double most_walk = (1 << 22) - (16 << 16) - 68;
  EXPECT_TRUE(are_pairs_anchored(box_of(0.5, most_turn, most_walk)));
  EXPECT_FALSE(are_pairs_anchored(box_of(0.5 / beyond, most_turn, 1)));
  EXPECT_FALSE(are_pairs_anchored(box_of(0, 0, 0)));
  EXPECT_FALSE(are_pairs_anchored(box_of(1, most_turn * beyond, 1)));
  EXPECT_FALSE(are_pairs_anchored(box_of(1, 0, most_walk * beyond)));
  EXPECT_FALSE(are_pairs_anchored(box_of(1, 0, HUGE_VAL)));
  EXPECT_FALSE(are_pairs_anchored(box_of(-1, -1, 1)));
}

TEST(VectorLimits, PairsAreLoweredByWhatHalfADenominatorMakesOfTheError) {
  for (const int64_t error_fx32 : {2, 65538}) {
    for (const double walk_fx16 : {0.0, 65536.0, kMostPairWalk_fx16}) {
      const double anchor_fx16 = 4.0 * static_cast<double>(error_fx32) / kFx32PerFx16;
      const double wanted =
          anchor_fx16 + kAnchoredRoundings * walk_fx16 / 16777216 + kAnchoredSlack_fx16;
      EXPECT_DOUBLE_EQ(pair_error_fx16(field_of(0, 0, error_fx32), box_of(1, 0, walk_fx16)),
                       wanted);
    }
  }
}

// Texels of 16 units that begin above every anchor, whatever the lowest bits of it and of the
// offset.
TEST(VectorLimits, CoarseLanesLackNoMoreThanTheyAreThoughtTo) {
  for (const int bits : {1, 2, 3, 4}) {
    for (const int32_t lack_fx16 : {1, 2, 3, 4, 15, 16, 17, 66}) {
      int32_t most = 0;
      const int32_t texel_fx16 = 16 << bits;
      for (int32_t anchor = 0; anchor < texel_fx16; ++anchor) {
        for (int32_t offset = 0; offset < 1 << bits; ++offset) {
          const int32_t last_fx16 = anchor + offset + lack_fx16 - 1;
          const int32_t begins_fx16 = last_fx16 / texel_fx16 * texel_fx16;
          const int32_t coarse = (anchor >> bits) + (offset >> bits);
          most = std::max(most, (begins_fx16 >> bits) - coarse);
        }
      }
      EXPECT_EQ(coarse_lack(bits, lack_fx16), most) << bits << " bits, lack " << lack_fx16;
    }
  }
}

TEST(VectorLimits, CoarseLanesLackATexelAtMost) {
  for (const int bits : {1, 2, 3, 4}) {
    const int32_t texel = 0x10000 >> bits;
    EXPECT_LT(coarse_lack(bits, 0x10000 - 4 * (1 << bits)), texel);
    for (const int32_t lack_fx16 : {0x10001, 0x10003, 0x7FFF0000}) {
      EXPECT_EQ(coarse_lack(bits, lack_fx16), texel) << bits << " bits, lack " << lack_fx16;
    }
  }
}

TEST(VectorLimits, LanesMayBeLowByATexel) {
  for (int32_t TexelBox::*const least : {&TexelBox::least_u_fx16, &TexelBox::least_v_fx16}) {
    Polygon polygon{};
    polygon.texels.*least = std::numeric_limits<int32_t>::min() + 65536;
    EXPECT_TRUE(lanes_fit(polygon));
    --(polygon.texels.*least);
    EXPECT_FALSE(lanes_fit(polygon));
    polygon.texels.*least = std::numeric_limits<int32_t>::min();
    EXPECT_FALSE(lanes_fit(polygon));
  }
}

TEST(VectorLimits, PlacesFit32Bits) {
  constexpr int32_t kRows = 1000;
  constexpr ptrdiff_t kMost_texel = INT32_MAX / kRows;
  selvage_texture texture = {
      nullptr, 4, kRows, 4 * kMost_texel, SELVAGE_RGBA8888, SELVAGE_LAYOUT_ROWS, nullptr};
  EXPECT_TRUE(places_fit(texture));
  texture.pitch = -texture.pitch;
  EXPECT_TRUE(places_fit(texture));
  texture.pitch -= 4;
  EXPECT_FALSE(places_fit(texture));
  texture.pitch = -texture.pitch;
  EXPECT_FALSE(places_fit(texture));
}

// Who asks for a kernel gets it, and not another that draws the same.
TEST(VectorLimits, EachKernelIsItsOwn) {
  const std::array filters = {SELVAGE_FILTER_NEAREST, SELVAGE_FILTER_FOUR, SELVAGE_FILTER_BILINEAR,
                              SELVAGE_FILTER_AREA};
  for (const selvage_filter filter : filters) {
    std::vector<const Kernels*> found = {&scalar_kernels(filter)};
    for (const selvage_kernel kernel : usable_kernels()) {
      if (kernel == SELVAGE_KERNEL_SCALAR) continue;
      const Kernels* const kernels = vector_kernels(kernel, filter);
      ASSERT_NE(kernels, nullptr) << "kernel " << kernel;
      for (const Kernels* const other : found) {
        EXPECT_NE(kernels->draw_affine, other->draw_affine) << "kernel " << kernel;
        EXPECT_NE(kernels->draw_projective, other->draw_projective) << "kernel " << kernel;
        if (filter != SELVAGE_FILTER_AREA) continue;
        EXPECT_NE(kernels->draw_boxes_affine, other->draw_boxes_affine) << "kernel " << kernel;
        EXPECT_NE(kernels->draw_boxes_projective, other->draw_boxes_projective) << kernel;
      }
      found.push_back(kernels);
    }
  }
  EXPECT_EQ(vector_kernels(SELVAGE_KERNEL_SCALAR, SELVAGE_FILTER_NEAREST), nullptr);
#ifdef __x86_64__
  EXPECT_EQ(vector_kernels(SELVAGE_KERNEL_NEON, SELVAGE_FILTER_NEAREST), nullptr);
#endif
}

}  // namespace
}  // namespace selvage::mapper
