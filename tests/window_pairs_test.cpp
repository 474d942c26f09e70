// Rows whose texels are a pixel wide or more, two at a time by one window, along them or a column
// of vectors after another: all signs of both steps, windows of all sizes, rows that begin and end
// one vector apart or many, one of two with no pixels, pitches that keep vectors in lines of the
// cache and others, windows at the edges of the texture, and near-ties in none, some or nearly all
// vectors, more than are kept at once.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>

#include "spec/random.h"
#include "spec/vertex_units.h"
#include "tests/any_surfaces.h"
#include "tests/kernel_support.h"

namespace selvage::mapper {
namespace {

using spec::kPixel_fx8;
using spec::kTexel_fx16;

// Texels of 1/256 a pixel, so that every vertex lies exactly in the plane.
struct Slopes {
  int32_t u_per_px, v_per_px, u_per_row, v_per_row;
};

[[nodiscard]] spec::Case any_magnified_target(spec::Random& random) {
  spec::Case c = any_surfaces(random);
  c.target_width_px = random.percent(70) ? random.in(60, 700) : random.in(700, 2400);
  c.target_height_px = random.percent(80) ? random.in(2, 40) : random.in(40, 140);
  c.texture_width_texel = random.pick({16, 17, 20, 64, 256, 256, 1024});
  c.texture_height_texel = random.pick({4, 5, 8, 15, 64, 256, 256, 600});
  const int32_t to_line_px = (kMostLanes - c.target_width_px % kMostLanes) % kMostLanes;
  c.padding_px = random.percent(50) ? to_line_px : random.in(0, 4);
  return c;
}

// Up to where a window holds no pair, and a little beyond; of rotations, of ties, or of any slopes.
[[nodiscard]] Slopes any_slopes(spec::Random& random) {
  const auto sign = [&] { return random.pick({1, -1}); };
  if (random.percent(25)) {
    const auto tie = [&] { return random.pick({0, 0, 1, 2, 32, 64}) * sign(); };
    return {tie(), tie(), tie(), tie()};
  }
  const int32_t most = random.pick({16, 60, 90, 128, 200, 260});
  if (random.percent(50)) {
    const int32_t along = random.in(0, most), across = random.in(0, most);
    return {along, across, -across, along};
  }
  const auto slope = [&](int32_t of) { return random.in(0, of + 1) * sign(); };
  return {slope(most), slope(random.percent(50) ? most : most / 2),
          slope(random.percent(20) ? 1000 : most), slope(most)};
}

// Where its corners lie: a rectangle, one whose sides are slanted by as much as rows are wide, or a
// triangle, maybe beyond the target.
void set_outline(spec::Random& random, spec::Case* c) {
  const int32_t width_fx8 = c->target_width_px * kPixel_fx8;
  const int32_t height_fx8 = c->target_height_px * kPixel_fx8;
  const int32_t slant_px = random.pick({0, 1, 20, 100, 600});
  const auto near = [&](int32_t at_fx8) {
    return at_fx8 + random.in(-slant_px, slant_px + 1) * kPixel_fx8 / 2 +
           random.pick({0, 0, 128, random.in(-256, 256)});
  };
  const int32_t over_fx8 = random.pick({0, 0, 100, 300 * kPixel_fx8});
  c->vertices = {{near(0), -over_fx8, 0, 0, 1},
                 {near(width_fx8), -over_fx8, 0, 0, 1},
                 {near(width_fx8), height_fx8 + over_fx8, 0, 0, 1},
                 {near(0), height_fx8 + over_fx8, 0, 0, 1}};
  if (random.percent(30)) c->vertices.erase(c->vertices.begin() + random.in(0, 4));
}

// All of it in the texture where that is large enough, or anywhere.
void set_texels(spec::Random& random, const Slopes& slopes, spec::Case* c) {
  static_assert(kPixel_fx8 * 256 == kTexel_fx16, "1/256 texel a pixel is 1 fx16 for 1 fx8");
  int32_t least_u = INT32_MAX, least_v = INT32_MAX;
  for (selvage_vertex& vertex : c->vertices) {
    vertex.u = slopes.u_per_px * vertex.x + slopes.u_per_row * vertex.y;
    vertex.v = slopes.v_per_px * vertex.x + slopes.v_per_row * vertex.y;
    least_u = std::min(least_u, vertex.u);
    least_v = std::min(least_v, vertex.v);
  }
  const bool fits = random.percent(80);
  const auto from = [&] {
    return random.pick({0, 0, kTexel_fx16 / 4, kTexel_fx16 / 2, random.in(0, 4 * kTexel_fx16)}) -
           (fits ? 0 : random.in(0, 40 * kTexel_fx16));
  };
  // Of pixel centres on boundaries, as far apart as the slope has them, or a unit before those:
  // that close below one, lanes leave it to the exact integers.
  const bool by_boundaries = random.percent(40);
  const auto offset = [&](int32_t least, int32_t per_px, int32_t per_row) {
    const int32_t any = from() - least;
    if (!by_boundaries) return any;
    const int32_t centre = (per_px + per_row) * kPixel_fx8 / 2;
    return (any & -kTexel_fx16) + 2 * kTexel_fx16 - centre - random.in(0, 3);
  };
  const int32_t u = offset(least_u, slopes.u_per_px, slopes.u_per_row);
  const int32_t v = offset(least_v, slopes.v_per_px, slopes.v_per_row);
  for (selvage_vertex& vertex : c->vertices) {
    vertex.u += u;
    vertex.v += v;
  }
}

// A block of seeds.
class WindowPairs : public testing::TestWithParam<uint64_t> {
 protected:
  static constexpr uint64_t kSeeds = 300;
};

TEST_P(WindowPairs, EveryKernelDrawsWhatTheScalarOneDraws) {
  for (uint64_t seed = GetParam() * kSeeds + 1; seed <= (GetParam() + 1) * kSeeds; ++seed) {
    spec::Random random(seed);
    spec::Case c = any_magnified_target(random);
    set_outline(random, &c);
    set_texels(random, any_slopes(random), &c);
    ASSERT_NO_FATAL_FAILURE(expect_drawn_alike(c, seed));
  }
}

INSTANTIATE_TEST_SUITE_P(Block, WindowPairs, testing::Range(uint64_t{0}, uint64_t{5}));

}  // namespace
}  // namespace selvage::mapper
