// What a face is drawn by keeps its bound, and the bound the tolerance, held against the exact
// model.
#include <gtest/gtest.h>

#include <cmath>
#include <iostream>
#include <map>

#include "coordinate_texture.h"
#include "plane_face.h"
#include "scene/plan.h"
#include "spec/exact.h"
#include "spec/gradient.h"

namespace selvage::scene {
namespace {

inline constexpr double kPlanTolerances_texel[] = {0, 1.0 / 16, 0.25, 1, 4, 64};

// How far an exact coordinate is from [texel, texel + 1).
[[nodiscard]] double distance(const spec::Rational& exact, int texel) {
  const double low = spec::Rational(texel - exact).get_d();
  const double high = spec::Rational(exact - (texel + 1)).get_d();
  return std::max({0.0, low, high});
}

// The greatest distance of a drawn texel from the exact u and v.
[[nodiscard]] double measured(const ScreenFace& face, const Drawn& drawn, int64_t& pixels) {
  double greatest = 0;
  for (int y = 0; y < kWideTarget.height_px; y += 9) {
    const auto line = spec::scan_line(face.vertices, y);
    if (!line) continue;
    for (int x = 0; x < kWideTarget.width_px; ++x) {
      const auto sample = spec::sample(*line, x);
      if (!sample) continue;
      const auto& pixel = drawn.pixels[static_cast<size_t>(y * kWideTarget.width_px + x)];
      greatest = std::max({greatest, distance(sample->u, pixel[0] | pixel[1] << 8),
                           distance(sample->v, pixel[2] | pixel[3] << 8)});
      ++pixels;
    }
  }
  return greatest;
}

[[nodiscard]] ScreenFace random_face(spec::Random& random) {
  for (;;) {
    const PlaneFace face(random, kWideTarget, random.in(3, 7));
    if (!face.is_beyond(0.3)) continue;
    ScreenFace screen{0, 0, {}, 0, {0, {}, {}}};
    EXPECT_EQ(snap(face.outline(), least_w(face.outline()), screen.vertices), SELVAGE_OK);
    if (doubled_area_seen(screen.vertices) != 0) return screen;
  }
}

TEST(Plan, MeasuredIsWithinItsBoundAndThatWithinTheTolerance) {
  const Scene scene = scene_with_texture();
  int64_t pixels = 0;
  std::map<std::string, int> drawn_by;
  double nearest_to_bound = 0;
  for (uint64_t seed = 1; seed <= 320; ++seed) {
    spec::Random random(seed);
    const ScreenFace face = random_face(random);
    const double tolerance = random.pick(kPlanTolerances_texel);
    SCOPED_TRACE("seed " + std::to_string(seed) + ", tolerance " + std::to_string(tolerance));
    Plan chosen = plan(scene, face, {tolerance, SELVAGE_FILTER_NEAREST});
    chosen.options.kernel = SELVAGE_KERNEL_SCALAR;  // has a choice; not every kernel has
    const Drawn drawn = draw(scene, face, chosen);
    const double bound = chosen.affine ? chosen.bound_texel : drawn.choice.bound / kSubtexels;
    const double found = measured(face, drawn, pixels);
    EXPECT_LE(found, bound);
    EXPECT_LE(bound, chosen.bound_texel);
    EXPECT_LE(chosen.bound_texel, std::max(0.0, tolerance - chosen.rounding_bound_texel));
    ++drawn_by[chosen.affine            ? "affine"
               : drawn.choice.bound > 0 ? "by the mapper's choice"
                                        : "exactly"];
    if (bound > 0) nearest_to_bound = std::max(nearest_to_bound, found / bound);
  }
  std::cout << pixels << " pixels; nearest to a bound: " << nearest_to_bound << " of it\n";
  for (const auto& [name, count] : drawn_by) std::cout << name << ": " << count << " faces\n";
  EXPECT_GT(pixels, 20000);
  EXPECT_GT(drawn_by["affine"], 20);
  EXPECT_GT(drawn_by["by the mapper's choice"], 20);
  EXPECT_GT(nearest_to_bound, 0.1);  // a bound that nothing comes near says little
}

// The bound of affine is one that two corners reach.
TEST(Plan, AffineBoundIsReached) {
  const double ratio = 4;  // (2 - 1) / (2 + 1) of the range, at two thirds of the way
  const std::vector<selvage_vertex> vertices = {
      {0, 0, 0, 0, 1 << 20}, {256 * 300, 0, 300 << 16, 0, 1 << 22}, {0, 256 * 10, 0, 0, 1 << 20}};
  const double bound = affine_bound_texel(vertices);
  EXPECT_NEAR(bound, 300 * (std::sqrt(ratio) - 1) / (std::sqrt(ratio) + 1), 1e-6);
  double greatest = 0;
  for (int x = 0; x < 280; ++x) {
    std::vector<selvage_vertex> affine = vertices;
    for (selvage_vertex& vertex : affine) vertex.q = 1;
    const auto exact = spec::sample(vertices, x, 0), drawn = spec::sample(affine, x, 0);
    if (exact && drawn)
      greatest = std::max(greatest, std::abs(spec::Rational(exact->u - drawn->u).get_d()));
  }
  EXPECT_LE(greatest, bound);
  EXPECT_GT(greatest, 0.98 * bound);
}

TEST(Plan, NothingIsAffineWithoutToleranceUnlessItIsExact) {
  const Scene scene = scene_with_texture();
  ScreenFace face{
      0, 0, {{0, 0, 0, 0, 5}, {9999, 0, 1 << 20, 0, 6}, {0, 9999, 0, 1 << 20, 5}}, 0, {0, {}, {}}};
  EXPECT_FALSE(plan(scene, face, {}).affine);
  EXPECT_EQ(plan(scene, face, {}).options.tolerance, 0);
  face.vertices[1].q = 5;
  EXPECT_TRUE(plan(scene, face, {}).affine);
  face.vertices[1].q = 500000;
  face.paint.texture.reset();
  EXPECT_TRUE(plan(scene, face, {}).affine);  // one colour
}

// Nearest only where every pixel is at most a texel wide, by the model's own derivatives.
TEST(Plan, FootprintsAreWithinTheirBound) {
  int64_t pixels = 0;
  double nearest_to_bound = 0;
  for (uint64_t seed = 1; seed <= 100; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    spec::Random random(seed);
    ScreenFace face = random_face(random);
    face.vertices.resize(3);
    if (doubled_area_seen(face.vertices) == 0) continue;
    const double bound = texels_per_px_bound(face.vertices);
    for (int y = 0; y < kWideTarget.height_px; y += 11) {
      const auto line = spec::scan_line(face.vertices, y);
      for (int x = 0; x < kWideTarget.width_px; x += 5) {
        if (!line || !spec::sample(*line, x)) continue;
        const auto gradient = spec::gradient(face.vertices, x, y);
        ASSERT_TRUE(gradient);
        const spec::Rational u = abs(gradient->u_along_x) + abs(gradient->u_along_y);
        const spec::Rational v = abs(gradient->v_along_x) + abs(gradient->v_along_y);
        const double here = std::max(u.get_d(), v.get_d());
        ASSERT_LE(here, bound) << x << ", " << y;
        nearest_to_bound = std::max(nearest_to_bound, here / bound);
        ++pixels;
      }
    }
  }
  std::cout << pixels << " pixels; nearest to a bound: " << nearest_to_bound << " of it\n";
  EXPECT_GT(pixels, 2000);
  EXPECT_GT(nearest_to_bound, 0.9);
}

// Corners with any texture, so that no one projective map holds; and with a plane's.
TEST(Plan, FootprintsOfRuledMapsAreWithinTheirBound) {
  int64_t pixels = 0;
  double nearest_to_bound = 0;
  for (uint64_t seed = 1; seed <= 60; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    spec::Random random(seed);
    ScreenFace face = random_face(random);
    if (face.vertices.size() < 4) continue;
    for (selvage_vertex& vertex : face.vertices) {
      if (seed % 3 != 0) vertex.u = random.in(-99, 99) * 65536;
      if (seed % 3 == 1) vertex.q = random.in(400, 1000);
    }
    const double bound = texels_per_px_bound(face.vertices);
    for (int y = 0; y < kWideTarget.height_px; y += 7) {
      for (int x = 0; x < kWideTarget.width_px; x += 5) {
        if (!spec::sample(face.vertices, x, y)) continue;
        const auto gradient = spec::gradient(face.vertices, x, y);
        ASSERT_TRUE(gradient);
        const spec::Rational u = abs(gradient->u_along_x) + abs(gradient->u_along_y);
        const spec::Rational v = abs(gradient->v_along_x) + abs(gradient->v_along_y);
        const double here = std::max(u.get_d(), v.get_d());
        ASSERT_LE(here, bound) << x << ", " << y;
        nearest_to_bound = std::max(nearest_to_bound, here / bound);
        ++pixels;
      }
    }
  }
  std::cout << pixels << " pixels; nearest to a bound: " << nearest_to_bound << " of it\n";
  EXPECT_GT(pixels, 1000);
  EXPECT_GT(nearest_to_bound, 0.9);
}

// Three corners magnify the texture, the fourth draws it together: several texels a pixel there.
TEST(Plan, OneCornerMayNeedTheAreaFilter) {
  const Scene scene = scene_with_texture();
  const ScreenFace face{0,
                        0,
                        {{0, 0, 0, 0, 1},
                         {0, 25600, 0, 20 << 16, 1},
                         {23000, 23000, 500 << 16, 500 << 16, 1},
                         {25600, 0, 20 << 16, 0, 1}},
                        0,
                        {0, {}, {}}};
  EXPECT_EQ(plan(scene, face, {}).options.filter, SELVAGE_FILTER_AREA);
}

TEST(Plan, AddressesAsTheTextureDoes) {
  Scene scene = scene_with_texture();
  spec::Random random(1);
  const ScreenFace face = random_face(random);
  for (const selvage_address address : {SELVAGE_ADDRESS_CLAMP, SELVAGE_ADDRESS_WRAP}) {
    scene.textures[0].address = address;
    EXPECT_EQ(plan(scene, face, {}).options.address, address);
  }
}

TEST(Plan, TakesTheFilterThatTheScaleNeeds) {
  const Scene scene = scene_with_texture();
  const auto filter_at = [&](int32_t texels, std::optional<selvage_filter> wished) {
    const ScreenFace face{
        0,
        0,
        {{0, 0, 0, 0, 1}, {100 * 256, 0, texels << 16, 0, 1}, {0, 100 * 256, 0, texels << 16, 1}},
        0,
        {0, {}, {}}};
    return plan(scene, face, {0, wished}).options.filter;
  };
  EXPECT_EQ(filter_at(99, {}), SELVAGE_FILTER_NEAREST);
  EXPECT_EQ(filter_at(101, {}), SELVAGE_FILTER_AREA);
  EXPECT_EQ(filter_at(101, SELVAGE_FILTER_BILINEAR), SELVAGE_FILTER_BILINEAR);
}

}  // namespace
}  // namespace selvage::scene
