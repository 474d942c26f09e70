// Small triangles where u or v is next to a whole texel at a pixel, as near as lanes may lie to it,
// or where lanes cannot tell them at all: every kernel draws what the scalar one draws.
#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <vector>

#include "spec/random.h"
#include "spec/vertex_units.h"
#include "tests/any_surfaces.h"
#include "tests/small_support.h"

namespace selvage::mapper {
namespace {

using spec::kPixel_fx8;
using spec::kTexel_fx16;

// Of the pixels inside some triangle of most of 16 x 16 of them: the first, the last, or another.
struct CoveredPixel {
  SmallOutline triangle;
  Weights weights;
};
[[nodiscard]] CoveredPixel any_covered_pixel(spec::Random& random) {
  const auto end = [&](bool far) { return (far ? 16 * kPixel_fx8 : 0) + random.in(-140, 141); };
  for (;;) {
    const size_t without = random.below(4);
    SmallOutline triangle;
    for (size_t corner = 0; corner < 4; ++corner) {
      if (corner == without) continue;
      const int32_t x = end(corner == 1 || corner == 2), y = end(corner >= 2);
      triangle.push_back({x, y, 0, 0, 1});
    }
    std::vector<Weights> inside;
    for (int32_t row = 0; row < 16; ++row) {
      for (int32_t px = 0; px < 16; ++px) {
        const Weights weights = weights_at(triangle, px * kPixel_fx8 + 128, row * kPixel_fx8 + 128);
        if (weights.are_inside()) inside.push_back(weights);
      }
    }
    if (inside.empty()) continue;
    const size_t any = random.below(inside.size());
    return {triangle, inside[random.pick({size_t{0}, inside.size() - 1, any})]};
  }
}

// Values at the vertices, within some texels, that are a whole texel at the pixel, but for so many
// units of 1 / (65536 D) texel, D being the doubled area. False where chance found none.
[[nodiscard]] bool set_near_whole(spec::Random& random, const Weights& weights, int64_t off,
                                  int32_t most_texel, int32_t selvage_vertex::*texel,
                                  SmallOutline* triangle) {
  const int64_t area = weights.sum(), back = inverse(weights.of[0] % area, area);
  const int64_t most_fx16 = int64_t{most_texel} * kTexel_fx16;
  for (int tries = 0; back != 0 && tries < 2000; ++tries) {
    const int64_t b = random.in(0, most_fx16), c = random.in(0, most_fx16);
    const int64_t others = weights.of[1] * b + weights.of[2] * c - off;
    // weight a = -others, modulo the area
    const int64_t missing = ((-others) % area + area) % area;
    const int64_t a = missing * back % area;
    if (a >= most_fx16) continue;
    const int64_t value_fx16 = (weights.of[0] * a + others) / area;
    const auto raise = static_cast<int32_t>(-value_fx16 & (kTexel_fx16 - 1));
    (*triangle)[0].*texel = static_cast<int32_t>(a) + raise;
    (*triangle)[1].*texel = static_cast<int32_t>(b) + raise;
    (*triangle)[2].*texel = static_cast<int32_t>(c) + raise;
    return true;
  }
  return false;
}

// A block of seeds.
class SmallWholeTexels : public testing::TestWithParam<uint64_t> {
 protected:
  static constexpr uint64_t kSeeds = 8000;
};

// A triangle of some texels where, at a pixel, u or v is whole but for so many units of 1 / 65536
// texel and the sum of the weights; on a texture of so many and one more. False where chance found
// none.
struct NearWhole {
  SmallOutline triangle;
  Weights weights;
  int32_t most_texel;
  int64_t off;
};
[[nodiscard]] bool set_near_whole(spec::Random& random, NearWhole* near) {
  const int32_t most_fx16 = random.pick({4, near->most_texel}) * kTexel_fx16;
  for (selvage_vertex& vertex : near->triangle) {
    const int32_t u = random.in(0, most_fx16), v = random.in(0, most_fx16);
    vertex.u = u;
    vertex.v = v;
  }
  const auto texel = random.pick({&selvage_vertex::u, &selvage_vertex::v});
  return set_near_whole(random, near->weights, near->off, near->most_texel, texel, &near->triangle);
}
void expect_near_whole_drawn_alike(spec::Random& random, const NearWhole& near, uint64_t seed) {
  spec::Case c = any_surfaces(random);
  c.target_width_px = c.target_height_px = 17;
  c.texture_width_texel = c.texture_height_texel = near.most_texel + 1;
  ASSERT_NO_FATAL_FAILURE(expect_list_drawn_alike(c, {near.triangle}, seed));
}

// At one pixel u or v is whole, or hardly more, or hardly less: as near as a lane may lie to it.
TEST_P(SmallWholeTexels, AreExactNextToThem) {
  int drawn = 0;
  for (uint64_t seed = GetParam() * kSeeds + 1; seed <= (GetParam() + 1) * kSeeds; ++seed) {
    spec::Random random(seed);
    const auto [triangle, weights] = any_covered_pixel(random);
    const int64_t area = weights.sum();
    // Lanes lack up to 35 / 256 of a unit of u and v, and are no more than floors.
    const int64_t most_off = random.pick({int64_t{1}, 4 * area / 256, 40 * area / 256});
    const int64_t off = random.percent(70) ? random.in(0, most_off) : -int64_t{random.in(0, 300)};
    NearWhole near{triangle, weights, random.pick({7, 15, 60}), off};
    if (!set_near_whole(random, &near)) continue;
    ++drawn;
    ASSERT_NO_FATAL_FAILURE(expect_near_whole_drawn_alike(random, near, seed));
  }
  EXPECT_GT(drawn, static_cast<int>(kSeeds / 4));
}

// Single precision is off to either side: by some units of 2^-24 texel, more where there are more
// texels.
TEST_P(SmallWholeTexels, AreExactNextToThemInPerspective) {
  int drawn = 0;
  for (uint64_t seed = GetParam() * kSeeds + 1; seed <= (GetParam() + 1) * kSeeds; ++seed) {
    spec::Random random(seed);
    auto [triangle, weights] = any_covered_pixel(random);
    const int32_t least_q = random.pick({1, 1, 16});
    for (size_t i = 0; i < triangle.size(); ++i) {
      triangle[i].q = random.in(least_q, 4 * least_q + 1);
      weights.of[i] *= triangle[i].q;
    }
    const int64_t most_off = random.pick({int64_t{1}, weights.sum() / 256, weights.sum() / 16});
    NearWhole near{triangle, weights, random.pick({1, 3, 7, 60}),
                   random.in(-most_off, most_off + 1)};
    if (!set_near_whole(random, &near)) continue;
    const int32_t scale = random.pick({1, SELVAGE_Q_MAX / 64});
    for (selvage_vertex& vertex : near.triangle) vertex.q *= scale;
    ++drawn;
    ASSERT_NO_FATAL_FAILURE(expect_near_whole_drawn_alike(random, near, seed));
  }
  EXPECT_GT(drawn, static_cast<int>(kSeeds / 8));
}

INSTANTIATE_TEST_SUITE_P(Block, SmallWholeTexels, testing::Range(uint64_t{0}, uint64_t{5}));

// Found by search: lanes that lack as much as any do at a pixel where u or v is hardly more than
// whole, and the exact values of the first pixel hardly less.
TEST(SmallLanes, AreExactWhereLanesLackMost) {
  const std::vector<SmallOutline> triangles = {
      {{4135, 4143, 225403, 185313, 1}, {4131, 36, 405398, 26674, 1}, {108, 4134, 9480, 189801, 1}},
      {{4122, 4015, 184408, 131171, 1},
       {3985, -18, 160973, 224116, 1},
       {34, 4157, 520201, 151711, 1}},
      {{4123, 4158, 456557, 201086, 1},
       {4113, 73, 479954, 359833, 1},
       {121, 4051, 485830, 258811, 1}},
      {{4214, 22, 449806, 55269, 1}, {4211, 4071, 330751, 364123, 1}, {33, 4057, 226323, 10945, 1}},
      {{46, 5, 284238, 402047, 1}, {-97, 4040, 498404, 299485, 1}, {3975, -75, 142465, 144732, 1}},
      {{-54, 4221, 335954, 524135, 1},
       {-44, 15, 514864, 47076, 1},
       {4056, -123, 302563, 165720, 1}}};
  spec::Case c;
  c.format = SELVAGE_INDEX8;
  c.target_width_px = c.target_height_px = 32;
  c.texture_width_texel = c.texture_height_texel = 8;
  for (const SmallOutline& triangle : triangles) {
    ASSERT_NO_FATAL_FAILURE(expect_list_drawn_alike(c, {triangle}, /*seed=*/0));
  }
}

// Found by search, too: needles of which the start alone, or a step alone, is more than lanes tell.
TEST(SmallLanes, AreExactWhereOneNumberIsBeyondLanes) {
  const std::vector<SmallOutline> needles = {{{10368, 8064, 8004354, 111186, 1},
                                              {9935, 8289, 7973865, 111185, 1},
                                              {13501, 6436, 8107703, 111185, 1}},
                                             {{1152, 3968, 196606, 8006116, 1},
                                              {219, 4722, 262144, 8006115, 1},
                                              {1496, 3690, 262141, 8006114, 1}},
                                             {{7296, 4992, 1768252, 296520, 1},
                                              {6975, 4087, 1928731, 296518, 1},
                                              {8187, 7504, 1867101, 296518, 1}},
                                             {{9059, 3097, 196605, 2587648, 1},
                                              {9808, 6075, 131069, 3541760, 1},
                                              {9600, 5248, 196606, 3276800, 1}}};
  spec::Case c;
  c.target_width_px = c.target_height_px = 60;
  c.texture_width_texel = c.texture_height_texel = 130;
  for (const SmallOutline& needle : needles) {
    ASSERT_NO_FATAL_FAILURE(expect_list_drawn_alike(c, {needle}, /*seed=*/0));
  }
}

// Found by search: in perspective, u two units of the texture's end, which lanes lowered by a sixth
// of their error reach.
TEST(SmallLanes, AreLoweredByTheErrorOfSinglePrecision) {
  spec::Case c;
  c.format = SELVAGE_INDEX8;
  c.target_width_px = 12;
  c.target_height_px = 50;
  c.texture_width_texel = 8;
  c.texture_height_texel = 65;
  const SmallOutline triangle = {{2782, 2889, 524286, 1441792, 4200428},
                                 {2321, 623, 524288, 1441792, 4255947},
                                 {171, 2609, 524287, 1441791, 4198011}};
  ASSERT_NO_FATAL_FAILURE(expect_list_drawn_alike(c, {triangle}, /*seed=*/0));
}

}  // namespace
}  // namespace selvage::mapper
