// Long rows by windows, which are found for a run of vectors at once, in perspective ahead of being
// drawn: rows of several runs, in perspective of windows of every shape in turn, with near-ties in
// nearly all vectors, so that more are left to others than are kept at once.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>

#include "spec/random.h"
#include "spec/vertex_units.h"
#include "tests/any_surfaces.h"
#include "tests/kernel_support.h"
#include "tests/rounded.h"
#include "tests/texel_map.h"

namespace selvage::mapper {
namespace {

using spec::kPixel_fx8;
using spec::kTexel_fx16;

// A long target of few rows, and a texture about as large as a window, or larger.
[[nodiscard]] spec::Case any_target(spec::Random& random) {
  spec::Case c = any_surfaces(random);
  c.target_width_px = random.in(250, 1400);
  c.target_height_px = random.in(1, 12);  // by strips from 8 on, where they are not too wide
  c.texture_width_texel = random.pick({8, 15, 16, 17, 20, 64, 100, 256, 256});
  c.texture_height_texel = random.pick({1, 2, 3, 4, 5, 10, 64, 100, 256, 256});
  c.padding_px = random.in(0, 4);
  return c;
}

// Most of it in the texture, or anywhere; ties along whole rows, or any slope up to a texel a
// pixel.
[[nodiscard]] TexelMap any_map(spec::Random& random, const spec::Case& c) {
  const bool fits = random.percent(60), ties = random.percent(50);
  const double across = (fits ? c.texture_width_texel : 400.0) / c.target_width_px;
  const double most = std::min(across, 1.0);
  const auto slope = [&] {
    if (ties) return random.pick({0.0, 0.5, 0.25, 0.125, 1.0 / 3, 1.0}) * random.pick({1, -1});
    return most * random.in(-1000, 1001) / 1000;
  };
  TexelMap map{0, 0, slope(), slope() * random.pick({0.0, 0.3, 1.0}), slope(), slope()};
  move(random, c, fits, ties, &map);
  return map;
}

// A rectangle over all of the target, or a triangle over most; q to be given by x in pixels.
template <class WeightAt>
void set_vertices(spec::Random& random, const TexelMap& map, const WeightAt& q_at, spec::Case* c) {
  const int32_t right_px = c->target_width_px, bottom_px = c->target_height_px;
  for (const int corner : {0, 1, 2, 3}) {
    const int32_t x_px = corner == 1 || corner == 2 ? right_px : 0;
    const int32_t y_px = corner >= 2 ? bottom_px : 0;
    const auto fx16 = [&](double texel) { return rounded(texel * kTexel_fx16); };
    c->vertices.push_back({x_px * kPixel_fx8, y_px * kPixel_fx8, fx16(map.u_at(x_px, y_px)),
                           fx16(map.v_at(x_px, y_px)), q_at(x_px)});
  }
  if (random.percent(40)) c->vertices.erase(c->vertices.begin() + random.in(0, 4));
}

// A block of seeds.
class WindowRuns : public testing::TestWithParam<uint64_t> {
 protected:
  static constexpr uint64_t kSeeds = 200;
};

TEST_P(WindowRuns, EveryKernelDrawsWhatTheScalarOneDraws) {
  for (uint64_t seed = GetParam() * kSeeds + 1; seed <= (GetParam() + 1) * kSeeds; ++seed) {
    spec::Random random(seed);
    spec::Case c = any_target(random);
    set_vertices(
        random, any_map(random, c), [](int32_t) { return 1; }, &c);
    ASSERT_NO_FATAL_FAILURE(expect_drawn_alike(c, seed));
  }
}

TEST_P(WindowRuns, EveryKernelDrawsWhatTheScalarOneDrawsInPerspective) {
  for (uint64_t seed = GetParam() * kSeeds + 1; seed <= (GetParam() + 1) * kSeeds; ++seed) {
    spec::Random random(seed);
    spec::Case c = any_target(random);
    const TexelMap map = any_map(random, c);
    const int32_t least_q = random.pick({1, 1000, 1 << 20});
    // q and all changes up to threefold, so that windows grow and shrink along a row; or by nothing
    // but a hair, and ties stay next to ties.
    const int32_t growth = random.pick({0, 1, 2}) * least_q, hair = random.in(0, 3);
    const bool falls = random.percent(50);
    const auto q_at = [&](int32_t x_px) {
      return least_q + ((x_px == 0) == falls ? growth + hair : 0);
    };
    set_vertices(random, map, q_at, &c);
    ASSERT_NO_FATAL_FAILURE(expect_drawn_alike(c, seed));
  }
}

INSTANTIATE_TEST_SUITE_P(Block, WindowRuns, testing::Range(uint64_t{0}, uint64_t{5}));

}  // namespace
}  // namespace selvage::mapper
