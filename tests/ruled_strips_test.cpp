// Quads that lie in no plane, drawn by strips: from one window, or from windows by one step for all
// rows, which is in doubt by what their steps are apart. Near-ties in none, some or nearly all of
// their pixels, steps that are nearly the same or too far apart for that.
#include <gtest/gtest.h>

#include <cstdint>

#include "spec/random.h"
#include "spec/vertex_units.h"
#include "tests/any_surfaces.h"
#include "tests/kernel_support.h"
#include "tests/modelled.h"
#include "tests/rounded.h"
#include "tests/texel_map.h"

namespace selvage::mapper {
namespace {

using spec::kPixel_fx8;
using spec::kTexel_fx16;

[[nodiscard]] spec::Case any_target(spec::Random& random) {
  spec::Case c = any_surfaces(random);
  c.target_width_px = random.pick({random.in(4, 70), random.in(60, 140), random.in(120, 560)});
  c.target_height_px = random.in(2, c.target_width_px > 140 ? 20 : 140);
  c.texture_width_texel = random.pick({7, 8, 16, 17, 64, 100, 256, 256});
  c.texture_height_texel = random.pick({2, 3, 4, 10, 64, 100, 256, 256});
  c.padding_px = random.in(0, 4);
  return c;
}

// At most a texel a pixel along a row, as windows ask; of ties along whole rows, or of any slope.
[[nodiscard]] TexelMap any_map(spec::Random& random, const spec::Case& c) {
  const bool ties = random.percent(50), fits = random.percent(60);
  const double most = random.pick({0.02, 0.2, 0.5, 1.0});
  const auto slope = [&] {
    if (ties) return random.pick({0.0, 0.5, 0.25, 0.125, 1.0}) * random.pick({1, -1});
    return most * random.in(-1000, 1001) / 1000;
  };
  TexelMap map{0, 0, slope(), slope() * random.pick({0.1, 1.0}), slope(), slope()};
  move(random, c, fits, ties, &map);
  if (random.percent(10)) {  // so far outside that lanes of 8.24, counted from an edge, would wrap
    map.u += random.in(-1, 2) * random.in(60, 400);
    map.v += random.in(-1, 2) * random.in(60, 400);
  }
  return map;
}

// Upright or slanted; one corner is off the map's plane, by some units of u and v, or of x and y.
void set_vertices(spec::Random& random, const TexelMap& map, spec::Case* c) {
  const int32_t width_fx8 = c->target_width_px * kPixel_fx8;
  const int32_t height_fx8 = c->target_height_px * kPixel_fx8;
  const int32_t slant_fx8 = random.percent(40) ? 0 : random.in(-width_fx8 / 3, width_fx8 / 3 + 1);
  const int32_t drop_fx8 = random.percent(40) ? 0 : random.in(-height_fx8 / 3, height_fx8 / 3 + 1);
  const int off_corner = random.in(0, 4);
  const auto off = [&] { return random.pick({-1, 0, 1, 2, 30, -300, 2000}); };
  for (const int corner : {0, 1, 2, 3}) {
    const bool is_right = corner == 1 || corner == 2, is_below = corner >= 2;
    int32_t x = (is_right ? width_fx8 : 0) + (is_below ? slant_fx8 : 0);
    int32_t y = (is_below ? height_fx8 : 0) + (is_right ? drop_fx8 : 0);
    const double x_px = x * (1.0 / kPixel_fx8), y_px = y * (1.0 / kPixel_fx8);
    int32_t u = rounded(map.u_at(x_px, y_px) * kTexel_fx16);
    int32_t v = rounded(map.v_at(x_px, y_px) * kTexel_fx16);
    if (corner == off_corner && random.percent(50)) {
      x += random.in(-2, 3);
      y += random.in(-2, 3);
    } else if (corner == off_corner) {
      u += off();
      v += off();
    }
    c->vertices.push_back({x, y, u, v, 1});
  }
}

[[nodiscard]] spec::Case any_case(uint64_t seed) {
  spec::Random random(seed);
  spec::Case c = any_target(random);
  set_vertices(random, any_map(random, c), &c);
  return c;
}

// A block of seeds.
class RuledStripsAtLength : public testing::TestWithParam<uint64_t> {
 protected:
  static constexpr uint64_t kSeeds = 10000;
};

TEST_P(RuledStripsAtLength, EveryKernelDrawsWhatTheScalarOneDraws) {
  for (uint64_t seed = GetParam() * kSeeds + 1; seed <= (GetParam() + 1) * kSeeds; ++seed) {
    ASSERT_NO_FATAL_FAILURE(expect_drawn_alike(any_case(seed), seed));
  }
}

TEST(RuledStrips, EveryKernelDrawsWhatTheScalarOneDraws) {
  for (uint64_t seed = 1000001; seed <= 1002000; ++seed) {
    ASSERT_NO_FATAL_FAILURE(expect_drawn_alike(any_case(seed), seed));
  }
}

// From a window at a clamped texture's edge, 218 texels away.
TEST(RuledStrips, FarFromTheTextureAreDrawnAlike) {
  spec::Case c;
  c.format = SELVAGE_RGB565;
  c.target_width_px = 35;
  c.target_height_px = 111;
  c.texture_width_texel = 277;
  c.texture_height_texel = 22;
  c.vertices = {{3040, 19841, 6258459, -14286874, 1},
                {3156, 22783, 6258431, -14287207, 1},
                {1747, 9473, 6258574, -14286997, 1},
                {1626, 3200, 6258632, -14286898, 1}};
  ASSERT_NO_FATAL_FAILURE(expect_drawn_alike(c, 0));
}

TEST(RuledStrips, AreDrawnAsModelled) {
  int drawn = 0;
  for (uint64_t seed = 1; drawn < 80; ++seed) {
    const spec::Case c = any_case(seed);
    if (c.target_width_px * c.target_height_px > 3000) continue;
    ASSERT_NO_FATAL_FAILURE(expect_drawn_as_modelled(c, spec::folded_texture(c.format)));
    ++drawn;
  }
}

INSTANTIATE_TEST_SUITE_P(Block, RuledStripsAtLength, testing::Range(uint64_t{0}, uint64_t{4}));

}  // namespace
}  // namespace selvage::mapper
