// Where vectors of pixels in perspective are counted from their first one: about the steepest turns
// and the longest walks that are, with ties, and a little beyond.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "mapper/projective_plane.h"
#include "mapper/vector/kernel.h"
#include "spec/random.h"
#include "tests/kernel_support.h"
#include "tests/rounded.h"

namespace selvage::mapper {
namespace {

inline constexpr int32_t kTargetHeight_px = 24;

// A triangle of which q runs from q_left to its last value over the width of the target, u and v by
// so many texels a pixel at the left.
[[nodiscard]] spec::Case with_any_turn(uint64_t seed) {
  static constexpr selvage_format kFormats[] = {SELVAGE_INDEX8, SELVAGE_RGB565, SELVAGE_RGBA8888};
  static constexpr int32_t kSizes[] = {1, 7, 8, 16, 33, 64, 100, 1024};
  static constexpr double kTurns[] = {0.001, 0.01, 0.03, 1.0 / 30, 0.034, 0.05};
  static constexpr double kSteps_texel[] = {1.0 / 4096, 0.125, 0.25, 1.0 / 3, 0.5, 1, 2, 4};
  spec::Random random(seed);
  spec::Case c;
  c.format = random.pick(kFormats);
  c.address = random.percent(50) ? SELVAGE_ADDRESS_CLAMP : SELVAGE_ADDRESS_WRAP;
  c.target_width_px = random.in(3, 150);
  c.target_height_px = kTargetHeight_px;
  c.texture_width_texel = random.pick(kSizes);
  c.texture_height_texel = random.pick(kSizes);
  const double turn = random.pick(kTurns) * (random.percent(50) ? 1 : -1);
  const double u_step = random.pick(kSteps_texel), v_step = random.pick(kSteps_texel);
  const double q_least = 16.0 * random.in(1, 4096);
  const double growth = std::exp(turn * c.target_width_px);
  const double q_left = growth > 1 ? q_least : q_least / growth;
  const int32_t u_texel = random.in(-200, 200), v_texel = random.in(-200, 200);
  for (int corner = 0; corner < 3; ++corner) {
    const int32_t x_px = corner == 0 ? 0 : random.in(0, c.target_width_px);
    const int32_t y_px = corner == 0   ? random.in(0, kTargetHeight_px)
                         : corner == 1 ? 0
                                       : kTargetHeight_px;
    const double q = q_left * (1 + x_px * turn);
    const int32_t along_px = corner == 2 ? c.target_width_px : x_px;
    c.vertices.push_back({(corner == 2 ? c.target_width_px : x_px) * 256, y_px * 256,
                          rounded((u_texel + along_px * u_step) * 65536),
                          rounded((v_texel + along_px * v_step + y_px * 0.25) * 65536),
                          std::clamp(rounded(q), 1, 1 << 23)});
  }
  return c;
}

void expect_drawings_of_the_scalar_kernel(int seeds) {
  int anchored = 0, not_anchored = 0, near_limits = 0;
  for (uint64_t seed = 1; seed <= static_cast<uint64_t>(seeds); ++seed) {
    const spec::Case c = with_any_turn(seed);
    Polygon polygon;
    if (examine(c.vertices, &polygon) != SELVAGE_OK || polygon.affine) continue;
    const auto plane = ProjectivePlane::of(polygon, {0, 0, c.target_width_px, c.target_height_px});
    if (plane) {
      const ProjectiveField& field = plane->lanes();
      (are_anchored(field) ? anchored : not_anchored) += 1;
      const double turn = (kMostLanes - 1) * field.turn / kMostTurn;
      const double walk = walk_fx16(field) / kMostWalk_fx16;
      near_limits += std::abs(std::max(turn, walk) - 0.9) < 0.1 ? 1 : 0;
    }
    const spec::Canvas scalar = drawing_of(c, SELVAGE_KERNEL_SCALAR);
    for (const selvage_kernel kernel : usable_kernels()) {
      ASSERT_TRUE(drawing_of(c, kernel) == scalar)
          << "kernel " << kernel << ", seed " << seed << "\n"
          << spec::print(c);
    }
  }
  EXPECT_GT(anchored, seeds / 6);
  EXPECT_GT(not_anchored, seeds / 12);
  EXPECT_GT(near_limits, seeds / 40);
  testing::Test::RecordProperty("anchored", anchored);
  testing::Test::RecordProperty("not_anchored", not_anchored);
  testing::Test::RecordProperty("near_limits", near_limits);
}

TEST(Anchored, EveryKernelDrawsWhatTheScalarOneDraws) { expect_drawings_of_the_scalar_kernel(600); }
TEST(AnchoredAtLength, EveryKernelDrawsWhatTheScalarOneDraws) {
  expect_drawings_of_the_scalar_kernel(6000);
}

// A row where u and v are whole at the centre of some pixel each, exactly, and walk about as far as
// they may: wherever an anchor's fraction is, lanes must not lack more than is thought. All but the
// tie is representable: u = k + m (x - x_tie) / q, where q is 2^10 at one end and divides m at the
// other.
[[nodiscard]] spec::Case with_exact_ties(uint64_t seed) {
  spec::Random random(seed);
  spec::Case c;
  c.target_width_px = random.in(45, 150);
  c.target_height_px = 1;
  c.texture_width_texel = c.texture_height_texel = 64;
  c.address = SELVAGE_ADDRESS_WRAP;
  constexpr int32_t kLeastQ = 1 << 10;
  const int32_t most_q = kLeastQ + random.in(1, 34);
  const bool falls = random.percent(50);
  const int32_t q_left = falls ? most_q : kLeastQ, q_right = falls ? kLeastQ : most_q;
  const int32_t width_fx8 = c.target_width_px * 256;
  c.vertices = {{0, 0, 0, 0, q_left},
                {width_fx8, 0, 0, 0, q_right},
                {width_fx8, 256, 0, 0, q_right},
                {0, 256, 0, 0, q_left}};
  for (int32_t selvage_vertex::*const texel : {&selvage_vertex::u, &selvage_vertex::v}) {
    const int32_t tie_fx8 = random.in(0, c.target_width_px) * 256 + 128;
    const int32_t whole = random.in(-5, 6);
    const int64_t rise = int64_t{most_q} * random.pick({1, -2, 3, 4, -4, 4, -4});
    for (selvage_vertex& vertex : c.vertices) {
      const int64_t beside_fx16 = rise * (vertex.x - tie_fx8) * 256 / vertex.q;
      vertex.*texel = static_cast<int32_t>(whole * 65536 + beside_fx16);
    }
  }
  return c;
}

TEST(Anchored, EveryKernelDecidesExactTies) {
  int anchored = 0;
  for (uint64_t seed = 1; seed <= 6000; ++seed) {
    const spec::Case c = with_exact_ties(seed);
    Polygon polygon;
    ASSERT_EQ(examine(c.vertices, &polygon), SELVAGE_OK);
    const auto plane = ProjectivePlane::of(polygon, {0, 0, c.target_width_px, 1});
    anchored += plane && are_anchored(plane->lanes()) ? 1 : 0;
    const spec::Canvas scalar = drawing_of(c, SELVAGE_KERNEL_SCALAR);
    for (const selvage_kernel kernel : usable_kernels()) {
      ASSERT_TRUE(drawing_of(c, kernel) == scalar)
          << "kernel " << kernel << ", seed " << seed << "\n"
          << spec::print(c);
    }
  }
  EXPECT_GT(anchored, 4000);
}

// As narrow as a vector, and on so few texels that one window holds them all.
[[nodiscard]] spec::Case with_narrow_ties(uint64_t seed) {
  spec::Random random(seed);
  spec::Case c = with_exact_ties(seed);
  c.target_width_px = random.in(3, 17);
  constexpr int32_t kLeastQ = 1 << 10;
  const int32_t most_q = kLeastQ + random.in(1, 32), width_fx8 = c.target_width_px * 256;
  for (selvage_vertex& vertex : c.vertices) {
    const bool right = vertex.x != 0;
    vertex.x = right ? width_fx8 : 0;
    vertex.q = right ? most_q : kLeastQ;
  }
  for (int32_t selvage_vertex::*const texel : {&selvage_vertex::u, &selvage_vertex::v}) {
    const int32_t tie_fx8 = random.in(0, c.target_width_px) * 256 + 128;
    const int32_t whole = random.in(-5, 60), sixteenths = random.in(1, 9) * random.pick({1, -1});
    for (selvage_vertex& vertex : c.vertices) {
      const int64_t beside_fx16 =
          int64_t{most_q} * sixteenths * (vertex.x - tie_fx8) * 16 / vertex.q;
      vertex.*texel = static_cast<int32_t>(whole * 65536 + beside_fx16);
    }
  }
  return c;
}

TEST(Anchored, EveryKernelDecidesExactTiesOfNarrowRows) {
  for (uint64_t seed = 1; seed <= 3000; ++seed) {
    const spec::Case c = with_narrow_ties(seed);
    const spec::Canvas scalar = drawing_of(c, SELVAGE_KERNEL_SCALAR);
    for (const selvage_kernel kernel : usable_kernels()) {
      ASSERT_TRUE(drawing_of(c, kernel) == scalar)
          << "kernel " << kernel << ", seed " << seed << "\n"
          << spec::print(c);
    }
  }
}

// Stairs of three rows, 8, 240 and 1056 pixels wide: v is whole along the first and the last one,
// so that one vector is left to be decided, then none, then more than there is room for.
TEST(Anchored, VectorsLeftFitTheirRoom) {
  spec::Case c;
  c.target_width_px = 1056;
  c.target_height_px = 3;
  c.texture_width_texel = c.texture_height_texel = 64;
  // v = (1/8 + 11/4 y) / (1 + y): 1, 1.7 and 2 at the rows' centres.
  static constexpr int32_t kV_fx16[] = {65536 / 8, 65536 * 23 / 16, 65536 * 15 / 8,
                                        65536 * 67 / 32};
  const auto at = [](int32_t x_px, int32_t y_px) {
    return selvage_vertex{x_px * 256, y_px * 256, 32768, kV_fx16[y_px], 1024 * (1 + y_px)};
  };
  c.vertices = {at(0, 0),   at(8, 0),    at(8, 1),    at(240, 1),
                at(240, 2), at(1056, 2), at(1056, 3), at(0, 3)};
  Polygon polygon;
  ASSERT_EQ(examine(c.vertices, &polygon), SELVAGE_OK);
  const auto plane = ProjectivePlane::of(polygon, {0, 0, c.target_width_px, 3});
  ASSERT_TRUE(plane && are_anchored(plane->lanes()));
  const spec::Canvas scalar = drawing_of(c, SELVAGE_KERNEL_SCALAR);
  for (const selvage_kernel kernel : usable_kernels()) {
    EXPECT_TRUE(drawing_of(c, kernel) == scalar) << "kernel " << kernel;
  }
}

}  // namespace
}  // namespace selvage::mapper
