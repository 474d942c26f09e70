// The whole bound, of mapping and of rounding to the grid, held against the map before rounding:
// near faces, and far ones beside something so near that few bits of q are left to them.
#include <gtest/gtest.h>

#include <cmath>
#include <iostream>

#include "coordinate_texture.h"
#include "plane_face.h"
#include "scene/plan.h"

namespace selvage::scene {
namespace {

inline constexpr double kRoundingTolerances_texel[] = {0, 1.0 / 16, 0.25, 1, 4};

// How far a texel is from all that u (or v) may be, before mapping and rounding depths.
[[nodiscard]] double distance(const Interval& interval, int texel) {
  return std::max({0.0, interval.least - (texel + 1), texel - interval.most});
}

[[nodiscard]] double measured(const PlaneFace& face, const Drawn& drawn, int64_t& pixels) {
  double greatest = 0;
  for (int y = 0; y < kWideTarget.height_px; y += 5) {
    for (int x = 0; x < kWideTarget.width_px; ++x) {
      const auto& pixel = drawn.pixels[static_cast<size_t>(y * kWideTarget.width_px + x)];
      if (pixel == kNothing || !is_before_horizon(face, x, y)) continue;
      greatest =
          std::max({greatest, distance(within_reach(face, x, y, 0), pixel[0] | pixel[1] << 8),
                    distance(within_reach(face, x, y, 1), pixel[2] | pixel[3] << 8)});
      ++pixels;
    }
  }
  return greatest;
}

struct Found {
  int64_t pixels = 0;
  int beyond_mapping = 0, beyond_tolerance = 0, within = 0;
  double nearest_to_bound = 0;
};

void hold(const Scene& scene, const PlaneFace& face, double w_near, double tolerance,
          Found& found) {
  ScreenFace screen{0, 0, {}, 0, {0, {}, {}}};
  ASSERT_EQ(snap(face.outline(), w_near, screen.vertices), SELVAGE_OK);
  if (doubled_area_seen(screen.vertices) == 0) return;
  const Plan chosen = plan(scene, screen, {tolerance, SELVAGE_FILTER_NEAREST});
  const Drawn drawn = draw(scene, screen, chosen);
  const double mapping = chosen.affine ? chosen.bound_texel : drawn.choice.bound / kSubtexels;
  const double whole = mapping + chosen.rounding_bound_texel;
  const double error = measured(face, drawn, found.pixels);
  EXPECT_LE(error, whole);
  if (chosen.rounding_bound_texel <= tolerance) {
    EXPECT_LE(whole, tolerance);
    ++found.within;
  } else {
    EXPECT_EQ(mapping, 0);
  }
  found.beyond_mapping += error > mapping + 1e-4;
  found.beyond_tolerance += error > tolerance + 1e-4;
  found.nearest_to_bound = std::max(found.nearest_to_bound, error / whole);
}

TEST(PlanRounding, MeasuredFromTheMapBeforeRoundingIsWithinTheWholeBound) {
  const Scene scene = scene_with_texture();
  Found found;
  for (uint64_t seed = 1; seed <= 240; ++seed) {
    spec::Random random(seed);
    const PlaneFace face(random, kWideTarget, random.in(3, 7));
    if (!face.is_beyond(0.3)) continue;
    const double tolerance = random.pick(kRoundingTolerances_texel);
    const double w_near = std::ldexp(least_w(face.outline()), -random.in(0, 22));
    SCOPED_TRACE("seed " + std::to_string(seed) + ", tolerance " + std::to_string(tolerance));
    hold(scene, face, w_near, tolerance, found);
  }
  std::cout << found.pixels << " pixels; " << found.beyond_mapping
            << " faces off by more than mapping them, " << found.beyond_tolerance
            << " by more than the tolerance, " << found.within
            << " with a whole bound within it; nearest to a bound: " << found.nearest_to_bound
            << " of it\n";
  EXPECT_GT(found.pixels, 100000);
  EXPECT_GT(found.beyond_mapping, 20);    // what mapping costs alone is no bound
  EXPECT_GT(found.beyond_tolerance, 10);  // far faces: the tolerance cannot be kept
  EXPECT_GT(found.within, 40);
  EXPECT_GT(found.nearest_to_bound, 0.3);
}

// Depths that cannot be told apart any more: no mean leaves the range.
TEST(PlanRounding, BoundIsNeverAboveTheRange) {
  const Scene scene = scene_with_texture();
  const ScreenFace face{
      0, 0, {{0, 0, 0, 0, 1}, {9999, 0, 64 << 16, 0, 1}, {0, 9999, 0, 9 << 16, 1}}, 0, {0, {}, {}}};
  const Plan chosen = plan(scene, face, {});
  EXPECT_NEAR(chosen.rounding_bound_texel, 64, 1e-3);
  EXPECT_GE(chosen.rounding_bound_texel, 64);
}

TEST(PlanRounding, OneColourHasNone) {
  ScreenFace face{0, 0, {{0, 0, 0, 0, 1}, {9999, 0, 9, 0, 2}, {0, 9999, 0, 9, 1}}, 0, {}};
  EXPECT_EQ(plan(scene_with_texture(), face, {}).rounding_bound_texel, 0);
}

}  // namespace
}  // namespace selvage::scene
