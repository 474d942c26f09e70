// Polygons near a plane and in none: the lanes of that plane, and what kernels draw by them.
#include "mapper/near_plane.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "mapper/kernel_choice.h"
#include "mapper/span_walk.h"
#include "spec/exact.h"
#include "spec/random.h"
#include "spec/vertex_units.h"
#include "tests/modelled.h"
#include "tests/slab_support.h"

namespace selvage::mapper {
namespace {

using spec::kPixel_fx8;
using spec::kTexel_fx16;
using spec::Rational;
using Vertices = std::vector<selvage_vertex>;

[[nodiscard]] std::optional<AffineField> lanes_of(const Vertices& vertices,
                                                  const selvage_rect& visible = kEverywhere) {
  Polygon polygon;
  EXPECT_EQ(examine(vertices, &polygon), SELVAGE_OK);
  return near_plane(polygon, part_of(polygon, visible));
}

void expect_lawful(const AffineField& lanes, const Vertices& vertices, int32_t px, int32_t row) {
  const auto exact = spec::sample(vertices, px, row);
  ASSERT_TRUE(exact.has_value());
  const Lane lane = lanes.at(px, row);
  const auto holds = [&](int64_t lane_fx32, const Rational& texel) {
    const Rational true_fx32 = texel * Rational(4294967296.0);
    return spec::rational(lane_fx32) <= true_fx32 &&
           true_fx32 < spec::rational(lane_fx32 + lanes.margin_fx32);
  };
  ASSERT_TRUE(holds(lane.u_fx32, exact->u) && holds(lane.v_fx32, exact->v))
      << "pixel " << px << ", " << row;
}

TEST(NearPlane, LanesAreLowByLessThanTheirMargin) {
  int near = 0, far = 0;
  for (uint64_t seed = 1; seed <= 6000; ++seed) {
    spec::Random random(seed);
    const Vertices vertices = any_quad(random, true);
    Polygon polygon;
    if (examine(vertices, &polygon) != SELVAGE_OK) continue;
    selvage_rect part = part_of(polygon, kEverywhere);
    part.left += random.in(0, (part.right - part.left) / 2 + 1);
    part.top += random.in(0, (part.bottom - part.top) / 2 + 1);
    if (is_empty(part)) continue;
    const auto lanes = near_plane(polygon, part);
    if (!lanes) {
      ++far;
      continue;
    }
    near += lanes->margin_fx32 > 1 ? 1 : 0;
    ASSERT_LE(lanes->margin_fx32, kMostNearMargin_fx32);
    part.bottom = std::min(part.bottom, part.top + 400);
    SpanWalk walk(polygon, part);
    while (walk.next()) {
      if (!random.percent(part.bottom - part.top > 40 ? 5 : 25)) continue;
      const Span& span = walk.span();
      for (const int32_t px :
           {span.left_px, random.in(span.left_px, span.right_px), span.right_px - 1}) {
        ASSERT_NO_FATAL_FAILURE(expect_lawful(*lanes, vertices, px, span.row)) << "seed " << seed;
      }
    }
  }
  EXPECT_GT(near, 1000);
  EXPECT_GT(far, 1500);
}

// The corner that is covered, for it lies on a pixel's centre, is the one that is furthest above.
TEST(NearPlane, LanesAreLowByLessThanTheirMarginAtACornerToo) {
  constexpr int32_t kAt_fx8 = kPixel_fx8 / 2, kEnd_fx8 = kAt_fx8 + 10 * kPixel_fx8;
  constexpr int32_t kEnd_fx16 = 10 * kTexel_fx16;
  for (const int32_t off_fx16 : {-3, -2, -1, 1, 2, 3}) {
    const Vertices vertices = {{kAt_fx8, kAt_fx8, off_fx16, off_fx16, 1},
                               {kEnd_fx8, kAt_fx8, kEnd_fx16, 0, 1},
                               {kEnd_fx8, kEnd_fx8, kEnd_fx16, kEnd_fx16, 1},
                               {kAt_fx8, kEnd_fx8, 0, kEnd_fx16, 1}};
    const auto lanes = lanes_of(vertices);
    ASSERT_TRUE(lanes.has_value());
    ASSERT_NO_FATAL_FAILURE(expect_lawful(*lanes, vertices, 0, 0)) << off_fx16;
  }
}

// One corner off a plane by e at a corner is off another by half of that at most.
TEST(NearPlane, IsOneThatIsAsFarOffAtAllCorners) {
  constexpr int32_t kSide_fx8 = 20 * kPixel_fx8, kSide_fx16 = 20 * kTexel_fx16, kOff_fx16 = 100;
  const auto lanes = lanes_of({{0, 0, 0, 0, 1},
                               {kSide_fx8, 0, kSide_fx16, 0, 1},
                               {kSide_fx8, kSide_fx8, kSide_fx16 + kOff_fx16, kSide_fx16, 1},
                               {0, kSide_fx8, 0, kSide_fx16, 1}});
  ASSERT_TRUE(lanes.has_value());
  EXPECT_NEAR(lanes->margin_fx32, kOff_fx16 * 65536.0 / 2, 64);
}

[[nodiscard]] Vertices square(int32_t side_px, double texels_a_px, int32_t off_fx16) {
  const int32_t side_fx8 = side_px * kPixel_fx8;
  const auto side_fx16 = static_cast<int32_t>(side_px * texels_a_px * kTexel_fx16);
  return {{0, 0, 0, 0, 1},
          {side_fx8, 0, side_fx16, 0, 1},
          {side_fx8, side_fx8, side_fx16 + off_fx16, side_fx16, 1},
          {0, side_fx8, 0, side_fx16, 1}};
}

TEST(NearPlane, IsNotOneThatIsFarOrThatLeavesMuchInDoubt) {
  EXPECT_TRUE(lanes_of(square(10, 1, 1000)).has_value());
  EXPECT_FALSE(lanes_of(square(10, 1, 1200)).has_value()) << "1/109 texel, of which half is left";
  EXPECT_TRUE(lanes_of(square(50, 1, 500)).has_value());
  EXPECT_FALSE(lanes_of(square(60, 1, 500)).has_value()) << "more than a near-tie in five rows";
  EXPECT_TRUE(lanes_of(square(50, 15, 1)).has_value());
  EXPECT_FALSE(lanes_of(square(50, 17, 1)).has_value()) << "steep";
  EXPECT_FALSE(lanes_of(square(50, -17, 1)).has_value()) << "steep";
}

TEST(NearPlane, IsOfAffinePolygonsWithAnArea) {
  Vertices deep = square(10, 1, 1);
  deep[2].q = 2;
  EXPECT_FALSE(lanes_of(deep).has_value());
  EXPECT_FALSE(
      lanes_of({{0, 0, 0, 0, 1}, {2560, 2560, 9, 0, 1}, {0, 2560, 0, 5, 1}, {2560, 5120, 0, 0, 1}})
          .has_value())
      << "diagonals of one direction";
}

// A quad of which all samples, or every other one, lie on boundaries but for what takes a corner
// off the plane, by units of 1/65536 texel; no texels of a row's vector are in one window.
[[nodiscard]] spec::Case any_near_tied(spec::Random& random) {
  spec::Case c;
  c.format = random.pick({SELVAGE_INDEX8, SELVAGE_RGB565, SELVAGE_RGBA8888});
  c.address = random.pick({SELVAGE_ADDRESS_CLAMP, SELVAGE_ADDRESS_WRAP});
  c.texture_width_texel = random.in(1, 70);
  c.texture_height_texel = random.in(1, 70);
  c.target_width_px = random.pick({random.in(1, 40), random.in(40, 100), random.in(100, 1400)});
  c.target_height_px = random.in(2, c.target_width_px > 100 ? 10 : 140);
  const int32_t q = random.pick<int32_t>({1, 1000, SELVAGE_Q_MAX});
  // Heights of edges are part of the denominators.
  const int32_t above_px = random.percent(20) ? random.in(0, 25000) : 0;
  const int32_t below_px = random.percent(20) ? random.in(0, 25000) : 0;
  const int32_t top_px = -above_px, bottom_px = c.target_height_px + below_px;
  const int32_t slant_px = above_px + below_px == 0 ? random.in(-8, 9) : 0;
  const int32_t a_px[4][2] = {{0, top_px},
                              {c.target_width_px, top_px},
                              {c.target_width_px + slant_px, bottom_px},
                              {slant_px, bottom_px}};
  const int32_t u_x = random.pick({-2, 1, 2, 3}), u_y = random.pick({-1, 0, 1});
  const int32_t v_x = u_x == 1 ? random.pick({-1, 1}) : 0, v_y = random.pick({-1, 1});
  const int32_t halves = random.percent(30) ? 2 : 1;
  const size_t off = random.below(4);
  for (size_t k = 0; k < 4; ++k) {
    const auto at = [&](int32_t x, int32_t y) {
      const int64_t twice_px = x * (2 * a_px[k][0] - 1) + y * (2 * a_px[k][1] - 1);
      const int64_t texel_fx16 = twice_px * kTexel_fx16 / (2 * halves);
      return static_cast<int32_t>(texel_fx16) + (k == off ? random.pick({-200, -1, 1, 2}) : 0);
    };
    c.vertices.push_back(
        {a_px[k][0] * kPixel_fx8, a_px[k][1] * kPixel_fx8, at(u_x, u_y), at(v_x, v_y), q});
  }
  return c;
}

TEST(NearPlane, KernelsDrawManyNearTiesAlike) {
  for (uint64_t seed = 1; seed <= 1500; ++seed) {
    spec::Random random(seed);
    ASSERT_NO_FATAL_FAILURE(expect_drawn_alike(any_near_tied(random), seed));
  }
}

// A rectangle turned by any angle, its corners rounded each by itself.
[[nodiscard]] spec::Case any_rounded(spec::Random& random, int32_t most_px) {
  spec::Case c;
  c.format = random.pick({SELVAGE_INDEX8, SELVAGE_RGB565, SELVAGE_RGBA8888});
  c.address = random.pick({SELVAGE_ADDRESS_CLAMP, SELVAGE_ADDRESS_WRAP});
  c.texture_width_texel = c.texture_height_texel = random.pick({1, 5, 16, 64, 100});
  c.target_width_px = c.target_height_px = random.in(4, most_px + 1);
  const double turn = random.in(0, 628319) / 100000.0;
  const double half_px = random.in(100, 50 * c.target_width_px + 1) / 100.0;
  const double texels_a_px = random.pick({0.1, 0.5, 1.0, 1.0, 2.0, 3.7});
  const double aspect = random.pick({1.0, 1.0, 0.2});
  for (int32_t k = 0; k < 4; ++k) {
    const double along = (k == 1 || k == 2 ? half_px : -half_px);
    const double across = (k >= 2 ? half_px : -half_px) * aspect;
    const double x_px = std::cos(turn) * along - std::sin(turn) * across;
    const double y_px = std::sin(turn) * along + std::cos(turn) * across;
    const double centre_px = c.target_width_px / 2.0 + 0.37;
    const auto rounded = [](double value, int32_t unit) {
      return static_cast<int32_t>(std::lround(value * unit));
    };
    c.vertices.push_back({rounded(centre_px + x_px, kPixel_fx8),
                          rounded(centre_px + y_px, kPixel_fx8),
                          rounded(40 + along * texels_a_px, kTexel_fx16),
                          rounded(30 + across * texels_a_px, kTexel_fx16), 1});
  }
  return c;
}

TEST(NearPlane, KernelsDrawQuadsOfRoundedCornersAlike) {
  for (uint64_t seed = 1; seed <= 3000; ++seed) {
    spec::Random random(seed);
    ASSERT_NO_FATAL_FAILURE(expect_drawn_alike(any_rounded(random, 200), seed));
  }
}

TEST(NearPlane, KernelsDrawWhatTheModelDoes) {
  for (uint64_t seed = 1; seed <= 200; ++seed) {
    spec::Random random(seed);
    const spec::Case c = any_near_tied(random);
    if (c.target_width_px * c.target_height_px > 2000) continue;
    ASSERT_NO_FATAL_FAILURE(expect_drawn_as_modelled(c, spec::folded_texture(c.format)));
  }
  for (uint64_t seed = 1; seed <= 60; ++seed) {
    spec::Random random(seed);
    const spec::Case c = any_rounded(random, 40);
    ASSERT_NO_FATAL_FAILURE(expect_drawn_as_modelled(c, spec::folded_texture(c.format)));
  }
}

}  // namespace
}  // namespace selvage::mapper
