// Magnified polygons that show few texels, of which many pixels are near-ties: within the texture,
// at its edges and across the seam of one that wraps; of one map and ruled, of several slabs, of
// the greatest denominators, narrow and wide.
#include <gtest/gtest.h>

#include <cstdint>

#include "spec/random.h"
#include "spec/vertex_units.h"
#include "tests/any_surfaces.h"
#include "tests/kernel_support.h"

namespace selvage::mapper {
namespace {

using spec::kPixel_fx8;
using spec::kTexel_fx16;

[[nodiscard]] spec::Case any_target(spec::Random& random) {
  spec::Case c = any_surfaces(random);
  c.target_width_px = random.percent(20) ? random.in(70, 400) : random.in(1, 70);
  c.target_height_px = random.in(4, 140);
  c.texture_width_texel = random.pick({1, 3, 7, 8, 9, 15, 16, 17, 64});
  c.texture_height_texel = random.pick({1, 2, 3, 4, 7, 8, 9, 10, 17, 19, 20, 64});
  return c;
}

// Fractions 1 / px_a_texel; whole at the centre of the target's first pixel.
struct Magnified {
  int32_t s, t, px_a_texel;
  int32_t s_right, s_down, t_right, t_down;
};

[[nodiscard]] Magnified any_map(spec::Random& random, const spec::Case& c) {
  const auto slope = [&] { return random.pick({0, 0, 1, 1, -1, 2}); };
  return {random.pick({0, 1, c.texture_width_texel / 2, c.texture_width_texel}),
          random.pick({0, 1, c.texture_height_texel / 2, c.texture_height_texel}),
          random.pick({4, 6, 16, 30, 64, 64, 1000}),
          slope(),
          slope(),
          slope(),
          slope()};
}

// Corners about the target's, or as far above and below it as there is room; texels lowered by a
// unit or two or not at all, and so maybe in no plane.
void set_vertices(spec::Random& random, const Magnified& map, spec::Case* c) {
  const int32_t right_px = c->target_width_px, down_px = c->target_height_px;
  const bool tall = random.percent(25), slanted = random.percent(30);
  const int32_t lowered = random.pick({0, 1, 1, 2});
  const int32_t across_q = random.pick({0, 0, 1, SELVAGE_Q_MAX / 3});
  const int32_t down_q = random.pick({0, 0, 1, SELVAGE_Q_MAX / 3});
  const int32_t moved_px = slanted ? random.in(-right_px, right_px) : 0;
  for (const int corner : {0, 1, 2, 3}) {
    const bool is_right = corner == 1 || corner == 2, is_below = corner >= 2;
    const int32_t tall_px = tall ? random.in(500, 30000) : 0;
    const int32_t x_px = (is_right ? right_px : 0) + (is_below ? moved_px : 0);
    const int32_t y_px = is_below ? down_px + tall_px : -tall_px;
    const auto off = [&] { return random.percent(20) ? random.in(-kPixel_fx8, kPixel_fx8) : 0; };
    const auto fx16 = [&](int32_t whole, int32_t right, int32_t down) {
      // Of what is tall, as much as the target shows.
      const int32_t shown_px = is_below ? down_px : 0;
      const int64_t steps = int64_t{right} * x_px + int64_t{down} * shown_px;
      return static_cast<int32_t>(whole * kTexel_fx16 + steps * kTexel_fx16 / map.px_a_texel) -
             random.in(0, lowered + 1);
    };
    const int32_t half_px = kPixel_fx8 / 2;
    c->vertices.push_back({x_px * kPixel_fx8 + half_px + off(), y_px * kPixel_fx8 + half_px + off(),
                           fx16(map.s, map.s_right, map.s_down),
                           fx16(map.t, map.t_right, map.t_down),
                           SELVAGE_Q_MAX - (is_right ? across_q : 0) - (is_below ? down_q : 0)});
  }
  if (random.percent(40)) c->vertices.erase(c->vertices.begin() + random.in(0, 4));
}

// A block of seeds.
class FewTexels : public testing::TestWithParam<uint64_t> {};

TEST_P(FewTexels, EveryKernelDrawsWhatTheScalarOneDraws) {
  constexpr uint64_t kSeeds = 1500;
  for (uint64_t seed = GetParam() * kSeeds + 1; seed <= (GetParam() + 1) * kSeeds; ++seed) {
    spec::Random random(seed);
    spec::Case c = any_target(random);
    set_vertices(random, any_map(random, c), &c);
    ASSERT_NO_FATAL_FAILURE(expect_drawn_alike(c, seed));
  }
}

INSTANTIATE_TEST_SUITE_P(Block, FewTexels, testing::Range(uint64_t{0}, uint64_t{4}));

}  // namespace
}  // namespace selvage::mapper
