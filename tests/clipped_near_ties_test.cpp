// Near-ties in a part of a polygon that a clip leaves: rows of any length, at any offset from the
// polygon's corners, of maps in any direction.
#include <gtest/gtest.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "mapper/number.h"
#include "spec/random.h"
#include "tests/near_ties_support.h"

namespace selvage::mapper {
namespace {

inline constexpr int32_t kClippedTarget_px = 300;

// How u, v and q change over a polygon, before they are nudged.
struct Slopes {
  int32_t u_right, u_down, v_right, v_down;  // texels in `slow` pixels
  int32_t slow;
  int32_t off_fx16;
  int32_t q[4];
};

// Texels that samples meet on their boundaries: each sample, or one in so many.
[[nodiscard]] Slopes any_slopes(spec::Random& random) {
  const auto slope = [&] { return random.pick({-1, 0, 0, 1, 1}); };
  Slopes slopes{slope(), slope(), slope(), slope(), random.pick({1, 1, 2, 3, 4, 6, 16}), 0, {}};
  const int32_t half_fx16 = 1 << (kTexelFraction - 1);
  slopes.off_fx16 = random.pick({0, half_fx16 / slopes.slow, half_fx16});
  const int32_t depth = random.in(0, 4);
  for (int32_t& q : slopes.q) {
    q = depth == 0   ? 1
        : depth == 1 ? SELVAGE_Q_MAX - random.in(0, 2)
        : depth == 2 ? SELVAGE_Q_MAX >> random.in(0, 2)
                     : (1 << random.in(20, 25)) - 1;
  }
  return slopes;
}

struct Corner {
  int32_t x_px, y_px;
};

[[nodiscard]] selvage_vertex vertex_at(const Corner& corner, const Slopes& slopes, size_t index,
                                       const Corner& texel, spec::Random& random) {
  const auto texel_fx16 = [&](int32_t right, int32_t down, int32_t first_texel) {
    const int64_t texels = int64_t{right} * corner.x_px + int64_t{down} * corner.y_px;
    const int64_t whole_fx16 = texels * (1 << kTexelFraction) / slopes.slow;
    return static_cast<int32_t>(whole_fx16 + int64_t{first_texel} * (1 << kTexelFraction)) +
           slopes.off_fx16 + (random.percent(60) ? random.in(-2, 3) : 0);
  };
  return {corner.x_px * kSubpixels, corner.y_px * kSubpixels,
          texel_fx16(slopes.u_right, slopes.u_down, texel.x_px),
          texel_fx16(slopes.v_right, slopes.v_down, texel.y_px), slopes.q[index]};
}

// A triangle with upright or slanted edges, or a quad, whose depths need not be those of a plane.
[[nodiscard]] std::vector<selvage_vertex> any_polygon(spec::Random& random) {
  const int32_t width_px = random.pick({16, 64, 300, 1024, 8192, 14000});
  const int32_t height_px = random.percent(60) ? width_px : random.pick({16, 300, 14000});
  const int32_t left_px = random.percent(50) ? 0 : -random.in(0, std::min(width_px, 200));
  const int32_t top_px = random.percent(50) ? 0 : -random.in(0, std::min(height_px, 200));
  const int32_t right_px = left_px + width_px, bottom_px = top_px + height_px;
  std::vector<Corner> corners{{left_px, top_px}, {right_px, top_px}, {left_px, bottom_px}};
  if (random.percent(30)) corners = {{right_px, top_px}, {right_px, bottom_px}, {left_px, top_px}};
  if (random.percent(30)) corners[1].y_px += height_px / 2;
  if (random.percent(25)) {
    corners = {{left_px, top_px}, {right_px, top_px}, {right_px, bottom_px}, {left_px, bottom_px}};
  }
  const Slopes slopes = any_slopes(random);
  const Corner texel{random.in(-40, 41), random.in(-40, 41)};
  std::vector<selvage_vertex> polygon;
  for (size_t i = 0; i < corners.size(); ++i) {
    polygon.push_back(vertex_at(corners[i], slopes, i, texel, random));
  }
  return polygon;
}

[[nodiscard]] selvage_rect any_clip(spec::Random& random) {
  const int32_t width_px = random.pick({1, 2, 3, 8, 16, 17, 33, 64, 65, kClippedTarget_px});
  const int32_t height_px = random.pick({1, 2, 70, 150});
  const int32_t left_px = random.in(0, kClippedTarget_px - width_px + 1);
  const int32_t top_px = random.in(0, kClippedTarget_px - height_px + 1) / random.pick({1, 4});
  return {left_px, top_px, left_px + width_px, top_px + height_px};
}

class ClippedNearTies : public testing::TestWithParam<uint64_t> {};

TEST_P(ClippedNearTies, AllPixelsAreDecidedAlikeByAllKernels) {
  constexpr uint64_t kSeeds = 100;
  for (uint64_t seed = GetParam() * kSeeds + 1; seed <= (GetParam() + 1) * kSeeds; ++seed) {
    spec::Random random(seed);
    const std::vector<selvage_vertex> polygon = any_polygon(random);
    const auto format = random.pick({SELVAGE_INDEX8, SELVAGE_RGB565, SELVAGE_RGBA8888});
    ASSERT_NO_FATAL_FAILURE(expect_near_ties_alike(polygon,
                                                   {.width_px = kClippedTarget_px,
                                                    .height_px = kClippedTarget_px,
                                                    .format = format,
                                                    .clip = any_clip(random)},
                                                   seed));
  }
}

INSTANTIATE_TEST_SUITE_P(Block, ClippedNearTies, testing::Range(uint64_t{0}, uint64_t{12}));

}  // namespace
}  // namespace selvage::mapper
