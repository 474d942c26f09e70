// Narrow rows, which are drawn by strips, some rows at once: rows of every width up to where strips
// end, in blocks that one pitch or another makes, by windows, by loads and from one window, under
// one map and ruled, with near-ties in none, some or all of their vectors.
#include <gtest/gtest.h>

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

[[nodiscard]] int32_t bytes_of(selvage_format format) {
  return format == SELVAGE_RGBA8888 ? 4 : format == SELVAGE_RGB565 ? 2 : 1;
}

// A column of a target, its rows maybe a pitch apart that puts many into one set of a cache, and a
// texture that is seldom larger than what is fetched at once.
[[nodiscard]] spec::Case any_target(spec::Random& random) {
  spec::Case c = any_surfaces(random);
  c.target_width_px = random.in(1, 75);
  c.target_height_px = random.in(1, 140);
  c.texture_width_texel = random.pick({1, 7, 8, 15, 16, 17, 20, 64, 100, 256, 256});
  c.texture_height_texel = random.pick({1, 2, 3, 4, 10, 64, 100, 256, 256});
  c.padding_px = random.in(0, 4);
  if (random.percent(20)) {
    const int32_t pitch_px = random.pick({512, 1024, 2048, 4096}) / bytes_of(c.format);
    c.padding_px = pitch_px - c.target_width_px;
  }
  return c;
}

// A texel a pixel or less mostly, up to four; of ties along whole rows or columns, or of any slope.
[[nodiscard]] TexelMap any_map(spec::Random& random, const spec::Case& c) {
  const bool ties = random.percent(40), fits = random.percent(60);
  const double most = random.pick({0.05, 0.25, 0.6, 1.0, 1.0, 4.0});
  const auto slope = [&] {
    if (ties) return random.pick({0.0, 0.0, 0.5, 0.25, 1.0 / 3, 1.0}) * random.pick({1, -1});
    return most * random.in(-1000, 1001) / 1000;
  };
  TexelMap map{0, 0, slope(), slope() * random.pick({0.0, 0.1, 1.0}), slope(), slope()};
  move(random, c, fits, ties, &map);
  return map;
}

// A quad about as large as the target, or a triangle, of straight or slanted sides; `off` of its
// corners' coordinates are off the map by a unit or many.
template <class WeightAt>
void set_vertices(spec::Random& random, const TexelMap& map, int off_percent, const WeightAt& q_at,
                  spec::Case* c) {
  const int32_t right_fx8 = c->target_width_px * kPixel_fx8;
  const int32_t bottom_fx8 = c->target_height_px * kPixel_fx8;
  const bool upright = random.percent(30);
  for (const int corner : {0, 1, 2, 3}) {
    const bool is_right = corner == 1 || corner == 2, is_below = corner >= 2;
    const auto moved = [&](int32_t to_fx8) {
      return upright ? 0 : random.in(-to_fx8 / 3, to_fx8 / 3 + 1);
    };
    const int32_t x = (is_right ? right_fx8 : 0) + moved(right_fx8);
    const int32_t y = (is_below ? bottom_fx8 : 0) + moved(bottom_fx8);
    const double x_px = x * (1.0 / kPixel_fx8), y_px = y * (1.0 / kPixel_fx8);
    const auto fx16 = [&](double texel) {
      const int32_t off = random.percent(off_percent) ? random.pick({-1, 1, 40, 70000}) : 0;
      return rounded(texel * kTexel_fx16) + off;
    };
    c->vertices.push_back(
        {x, y, fx16(map.u_at(x_px, y_px)), fx16(map.v_at(x_px, y_px)), q_at(is_right, is_below)});
  }
  if (random.percent(40)) c->vertices.erase(c->vertices.begin() + random.in(0, 4));
}

// A block of seeds.
class NarrowRows : public testing::TestWithParam<uint64_t> {
 protected:
  static constexpr uint64_t kSeeds = 1000;

  template <class SetVertices>
  void expect_all_drawn_alike(const SetVertices& set) {
    for (uint64_t seed = GetParam() * kSeeds + 1; seed <= (GetParam() + 1) * kSeeds; ++seed) {
      spec::Random random(seed);
      spec::Case c = any_target(random);
      set(random, &c);
      ASSERT_NO_FATAL_FAILURE(expect_drawn_alike(c, seed));
    }
  }
};

int32_t one(bool /*right*/, bool /*below*/) { return 1; }

TEST_P(NarrowRows, EveryKernelDrawsWhatTheScalarOneDraws) {
  expect_all_drawn_alike([](spec::Random& random, spec::Case* c) {
    set_vertices(random, any_map(random, *c), random.pick({0, 0, 10, 60}), one, c);
  });
}

TEST_P(NarrowRows, EveryKernelDrawsWhatTheScalarOneDrawsInPerspective) {
  expect_all_drawn_alike([](spec::Random& random, spec::Case* c) {
    const int32_t least_q = random.pick({1, 1000, 1 << 20});
    const int32_t across = random.pick({0, 1, least_q / 4, least_q});
    const int32_t down = random.pick({0, 1, least_q / 3, 2 * least_q});
    const auto q_at = [&](bool right, bool below) {
      return least_q + (right ? across : 0) + (below ? down : 0);
    };
    set_vertices(random, any_map(random, *c), random.pick({0, 0, 10}), q_at, c);
  });
}

INSTANTIATE_TEST_SUITE_P(Block, NarrowRows, testing::Range(uint64_t{0}, uint64_t{5}));

// Larger than what is fetched at once: asked for ahead.
TEST(NarrowRows, DrawFromTexturesThatNoCacheHolds) {
  for (uint64_t seed = 1; seed <= 12; ++seed) {
    spec::Random random(seed);
    spec::Case c = any_target(random);
    c.format = SELVAGE_INDEX8;
    c.texture_width_texel = 4096;
    c.texture_height_texel = 2049;
    c.padding_px = 1;
    set_vertices(random, {100, 90, 3.7, -2.1, 1.3, 4.2}, random.pick({0, 0, 60}), one, &c);
    ASSERT_NO_FATAL_FAILURE(expect_drawn_alike(c, seed));
  }
}

}  // namespace
}  // namespace selvage::mapper
