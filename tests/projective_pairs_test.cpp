// Wide rows in perspective whose texels are some pixels wide, two at a time by one window: depths
// that grow along any way, rows that begin and end apart, one of two with no pixels, windows at the
// edges of the texture, and near-ties in none, some or nearly all vectors.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "mapper/projective_plane.h"
#include "mapper/vector/kernel.h"
#include "spec/random.h"
#include "spec/vertex_units.h"
#include "tests/any_surfaces.h"
#include "tests/kernel_support.h"
#include "tests/rounded.h"

namespace selvage::mapper {
namespace {

using spec::kPixel_fx8;
using spec::kTexel_fx16;

[[nodiscard]] spec::Case any_wide_target(spec::Random& random) {
  spec::Case c = any_surfaces(random);
  c.target_width_px = random.percent(70) ? random.in(60, 700) : random.in(700, 2400);
  c.target_height_px = random.percent(80) ? random.in(2, 40) : random.in(40, 140);
  c.texture_width_texel = random.pick({16, 17, 64, 256, 1024});
  c.texture_height_texel = random.pick({1, 2, 3, 4, 5, 8, 64, 256, 1024});
  c.padding_px = random.in(0, 4);
  return c;
}

// Triangles, which have one map whatever their vertices: around the target, so that it is a
// rectangle; or with slanted sides.
void set_outline(spec::Random& random, spec::Case* c) {
  const int32_t width_px = c->target_width_px, height_px = c->target_height_px;
  const int32_t slant_px = random.pick({0, 1, 20, 100, 600});
  const auto near = [&](int32_t at_px) {
    return at_px * kPixel_fx8 + random.in(-slant_px, slant_px + 1) * kPixel_fx8 / 2 +
           random.pick({0, 0, 128, random.in(-256, 256)});
  };
  const int32_t over_px = random.pick({0, 0, 3, 300});
  c->vertices = {
      {near(0), near(-over_px), 0, 0, 1},
      {near(width_px), near(-over_px), 0, 0, 1},
      {near(random.pick({0, width_px / 2, width_px})), near(height_px + over_px), 0, 0, 1}};
  if (random.percent(40)) {
    c->vertices[1].x += width_px * kPixel_fx8;
    c->vertices[2].y += height_px * kPixel_fx8;
  }
}

// Depths, and texels, up to where a window holds no pair and a little beyond.
void set_map(spec::Random& random, spec::Case* c) {
  const double most_growth = random.pick({0.001, 0.1, 0.5, 1.0, 4.0});
  const auto growth = [&] { return most_growth * random.in(-100, 101) / 100; };
  const double along_x = growth() / c->target_width_px, along_y = growth() / c->target_height_px;
  const double most_texel = random.pick({1.0 / 16, 0.25, 0.35, 0.5, 0.8});
  const auto slope = [&] { return most_texel * random.in(-100, 101) / 100; };
  const double u_x = slope(), u_y = slope(), v_x = slope() / random.pick({1, 8}), v_y = slope();
  double least = HUGE_VAL;
  for (const selvage_vertex& vertex : c->vertices) {
    least = std::min(least, along_x * vertex.x + along_y * vertex.y);
  }
  int32_t least_u = INT32_MAX, least_v = INT32_MAX, most_u = INT32_MIN, most_v = INT32_MIN;
  const double q_least = random.pick({16, 1000, 1 << 16});
  for (selvage_vertex& vertex : c->vertices) {
    const double x_px = vertex.x / 256.0, y_px = vertex.y / 256.0;
    const double q = 1 + (along_x * vertex.x + along_y * vertex.y - least) / 256;
    vertex.q = std::clamp(rounded(q * q_least), 1, int{SELVAGE_Q_MAX});
    vertex.u = rounded((u_x * x_px + u_y * y_px) * kTexel_fx16);
    vertex.v = rounded((v_x * x_px + v_y * y_px) * kTexel_fx16);
    least_u = std::min(least_u, vertex.u);
    least_v = std::min(least_v, vertex.v);
    most_u = std::max(most_u, vertex.u);
    most_v = std::max(most_v, vertex.v);
  }
  // At either edge of the texture, or a little beyond, or all but anywhere.
  const bool fits = random.percent(85);
  const auto by = [&](int32_t least_fx16, int32_t most_fx16, int32_t size_texel) {
    const int32_t inside_fx16 =
        random.pick({0, 0, 1, 100, kTexel_fx16 / 2, random.in(0, 4 * kTexel_fx16)});
    const int32_t beyond_fx16 = fits ? 0 : random.pick({1, 100, random.in(0, 40 * kTexel_fx16)});
    return random.percent(50) ? inside_fx16 - beyond_fx16 - least_fx16
                              : size_texel * kTexel_fx16 - inside_fx16 + beyond_fx16 - most_fx16;
  };
  const int32_t u = by(least_u, most_u, c->texture_width_texel);
  const int32_t v = by(least_v, most_v, c->texture_height_texel);
  for (selvage_vertex& vertex : c->vertices) {
    vertex.u += u;
    vertex.v += v;
  }
}

// Of all batches that a case has, how many have a map as gentle as pairs ask for.
[[nodiscard]] int gentle_batches(const spec::Case& c) {
  Polygon polygon;
  if (examine(c.vertices, &polygon) != SELVAGE_OK || polygon.affine) return 0;
  const selvage_rect target{0, 0, c.target_width_px, c.target_height_px};
  const selvage_rect part{std::max(polygon.left_px, 0), std::max(polygon.top_row, 0),
                          std::min(polygon.right_px, target.right),
                          std::min(polygon.bottom_row, target.bottom)};
  if (part.left >= part.right || part.top >= part.bottom) return 0;
  const auto plane = ProjectivePlane::of(polygon, target);
  if (!plane) return 0;
  BatchWalk walk(polygon, part, find_spans_scalar);
  SpanBatch batch;
  int gentle = 0;
  while (walk.next(&batch)) {
    if (batch.widest_px == 0) continue;
    const ProjectiveBox box(plane->lanes(), batch);
    gentle += are_pairs_anchored(box) ? 1 : 0;
  }
  return gentle;
}

// A block of seeds.
class ProjectivePairs : public testing::TestWithParam<uint64_t> {
 protected:
  static constexpr uint64_t kSeeds = 300;
};

TEST_P(ProjectivePairs, EveryKernelDrawsWhatTheScalarOneDraws) {
  int gentle = 0;
  for (uint64_t seed = GetParam() * kSeeds + 1; seed <= (GetParam() + 1) * kSeeds; ++seed) {
    spec::Random random(seed);
    spec::Case c = any_wide_target(random);
    set_outline(random, &c);
    set_map(random, &c);
    ASSERT_NO_FATAL_FAILURE(expect_drawn_alike(c, seed));
    gentle += gentle_batches(c);
  }
  EXPECT_GT(gentle, 150);
}

// Rows all alike, few or so many that more vectors are left than there is room for, where u and v
// are whole at the centre of some pixel each, exactly: u = k + m (x -
// x_tie) / q, where q is 2^10 at one end and divides m at the other.
TEST_P(ProjectivePairs, EveryKernelDecidesExactTies) {
  constexpr uint64_t kTieSeeds = kSeeds / 5;
  int gentle = 0;
  for (uint64_t seed = GetParam() * kTieSeeds + 1; seed <= (GetParam() + 1) * kTieSeeds; ++seed) {
    spec::Random random(seed);
    spec::Case c = any_surfaces(random);
    c.target_width_px = random.in(90, 600);
    c.target_height_px = random.percent(80) ? random.in(2, 12) : random.in(60, 130);
    c.texture_width_texel = c.texture_height_texel = 1024;
    constexpr int32_t kLeastQ = 1 << 10;
    const int32_t most_q = kLeastQ + random.in(1, 400);
    const bool falls = random.percent(50);
    const int32_t q_left = falls ? most_q : kLeastQ, q_right = falls ? kLeastQ : most_q;
    const int32_t width_fx8 = c.target_width_px * 256, height_fx8 = c.target_height_px * 256;
    c.vertices = {{0, 0, 0, 0, q_left},
                  {width_fx8, 0, 0, 0, q_right},
                  {width_fx8, height_fx8, 0, 0, q_right},
                  {0, height_fx8, 0, 0, q_left}};
    for (int32_t selvage_vertex::*const texel : {&selvage_vertex::u, &selvage_vertex::v}) {
      const int64_t rise = int64_t{most_q} * random.pick({-3, -1, 1, 2, 4, 6});
      // Anywhere, or at the pixel where it is greatest: the texture ends there.
      const bool at_end = random.percent(25);
      const int32_t tie_px = !at_end    ? random.in(0, c.target_width_px)
                             : rise > 0 ? c.target_width_px - 1
                                        : 0;
      const int32_t tie_fx8 = tie_px * 256 + 128, whole = at_end ? 1024 : 512;
      for (selvage_vertex& vertex : c.vertices) {
        const int64_t beside_fx16 = rise * (vertex.x - tie_fx8) * 32 / vertex.q;
        vertex.*texel = static_cast<int32_t>(whole * 65536 + beside_fx16);
      }
    }
    ASSERT_NO_FATAL_FAILURE(expect_drawn_alike(c, seed));
    gentle += gentle_batches(c);
  }
  EXPECT_GT(gentle, 20);
}

// The upper of two rows ends where u, far beyond its end, would be the greatest number of 16.16 and
// more, and the lower one has pixels: with what lanes lack added, a window seemed to hold both.
TEST(ProjectivePairsSeed, LanesBesideARowMayBeTheGreatestThereAre) {
  spec::Case c;
  c.format = SELVAGE_INDEX8;
  c.target_width_px = 32704;
  c.target_height_px = 64;
  c.has_clip = true;
  c.clip = {31760, 0, 32704, 64};
  c.texture_width_texel = 16384;
  c.texture_height_texel = 4;
  c.vertices = {{-8388608, 128, 1567923238, 98304, 768},
                {8388352, 129, 1299168517, 98304, 1387},
                {8388352, 16640, 965754198, 98304, 16509448}};
  ASSERT_NO_FATAL_FAILURE(expect_drawn_alike(c, 0));
  c.texture_height_texel = 3;
  c.vertices = {{-8388608, 128, 1529754390, 98304, 758},
                {8388352, 129, 1224308148, 98304, 1392},
                {8388352, 16640, 859167420, 98304, 16499669}};
  ASSERT_NO_FATAL_FAILURE(expect_drawn_alike(c, 0));
}

INSTANTIATE_TEST_SUITE_P(Block, ProjectivePairs, testing::Range(uint64_t{0}, uint64_t{5}));

}  // namespace
}  // namespace selvage::mapper
