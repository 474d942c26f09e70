// Lanes of 8.24 in the rows of one window: they are as low as the steps from the first column and
// row make them, which ties find out, and tell texels near the window alone.
#include <gtest/gtest.h>

#include <cstdint>
#include <utility>
#include <vector>

#include "spec/random.h"
#include "spec/vertex_units.h"
#include "tests/kernel_support.h"

namespace selvage::mapper {
namespace {

using spec::kPixel_fx8;
using spec::kTexel_fx16;

// A parallelogram that leans by `lean_px` a row, 1 more than a multiple of 3: u is a twelfth of
// what x is right of its left edge, so that every twelfth sample of a row lies on a boundary, or
// past one. A step of 2^24 / 12 loses a third of a unit, and there are up to some thousand of them.
[[nodiscard]] spec::Case any_leaning(spec::Random& random, int32_t lean_px, int32_t past_fx16) {
  constexpr int32_t kWidth_texel = 5, kWidth_px = 12 * kWidth_texel;
  spec::Case c;
  c.format = random.pick({SELVAGE_INDEX8, SELVAGE_RGB565, SELVAGE_RGBA8888});
  c.texture_width_texel = c.texture_height_texel = 16;
  c.target_height_px = random.in(2, 64);
  const int32_t leant_px = lean_px * c.target_height_px;
  c.target_width_px = kWidth_px + (leant_px < 0 ? -leant_px : leant_px);
  const int32_t top_px = leant_px < 0 ? -leant_px : 0, bottom_px = top_px + leant_px;
  const int32_t left_fx16 = kTexel_fx16 + (lean_px - 1) * kTexel_fx16 / 24 + past_fx16;
  const int32_t u_fx16 = (left_fx16 & (kTexel_fx16 - 1)) + random.in(1, 8) * kTexel_fx16;
  const int32_t v_fx16 = random.in(0, 16 * kTexel_fx16);
  const auto corner = [&](int32_t x_px, int32_t y_px, int32_t right_texel) {
    return selvage_vertex{x_px * kPixel_fx8, y_px * kPixel_fx8, u_fx16 + right_texel * kTexel_fx16,
                          v_fx16, 1};
  };
  c.vertices = {corner(top_px, 0, 0), corner(top_px + kWidth_px, 0, kWidth_texel),
                corner(bottom_px + kWidth_px, c.target_height_px, kWidth_texel),
                corner(bottom_px, c.target_height_px, 0)};
  return c;
}

// `seed`: 0 for cases that are written down.
void expect_all_draw_the_same(const spec::Case& c, uint64_t seed) {
  const spec::Canvas right = drawing_of(c, SELVAGE_KERNEL_SCALAR);
  for (const selvage_kernel kernel : usable_kernels()) {
    ASSERT_TRUE(drawing_of(c, kernel) == right) << "kernel " << kernel << ", seed " << seed << "\n"
                                                << spec::print(c);
  }
}

TEST(FineLanes, OfRowsThatLeanFarShowTheTexelsOfTies) {
  for (uint64_t seed = 1; seed <= 200; ++seed) {
    spec::Random random(seed);
    const int32_t lean_px = 1 + 3 * random.in(-20, 21);
    expect_all_draw_the_same(any_leaning(random, lean_px, 0), seed);
  }
}

// What they lack changes a lane there, and no texel: all of a row is drawn.
TEST(FineLanes, OfRowsThatLeanFarAreWholeWhereSamplesAreOnHalfATexel) {
  for (uint64_t seed = 1; seed <= 50; ++seed) {
    spec::Random random(seed);
    const int32_t lean_px = 1 + 3 * random.in(-20, 21);
    expect_all_draw_the_same(any_leaning(random, lean_px, kTexel_fx16 / 2), seed);
  }
}

struct Size {
  int32_t width, height;
};
[[nodiscard]] spec::Case case_of(selvage_format format, const Size& texture_texel,
                                 const Size& target_px, std::vector<selvage_vertex> vertices) {
  spec::Case c;
  c.format = format;
  c.texture_width_texel = texture_texel.width;
  c.texture_height_texel = texture_texel.height;
  c.target_width_px = target_px.width;
  c.target_height_px = target_px.height;
  c.vertices = std::move(vertices);
  return c;
}

// The row that leans farthest is not the first one, rows count among the steps, and half of the
// steps are not enough: ties of the other rows are no near-ties then.
TEST(FineLanes, OfTheFarthestRowShowTheTexelsOfTies) {
  const spec::Case rows = case_of(SELVAGE_RGB565, {17, 12}, {203, 56},
                                  {{-683520, 768, 524288, 426231, 7},
                                   {-676864, 768, 851968, 426231, 7},
                                   {615680, 26112, 851968, 426231, 7},
                                   {609024, 26112, 524288, 426231, 7}});
  spec::Case last = case_of(SELVAGE_RGBA8888, {11, 10}, {2277, 33},
                            {{1968640, 30464, 524288, 65536, 7},
                             {1981952, 30464, 851968, 65536, 7},
                             {-153856, 4096, 851968, 65536, 7},
                             {-167168, 4096, 524288, 65536, 7}});
  last.flip_texture = true;
  const spec::Case half = case_of(SELVAGE_RGB565, {18, 17}, {2462, 11},
                                  {{168960, -14592, 720896, 1076024, 7},
                                   {173568, -14592, 589824, 1076024, 7},
                                   {968448, 14848, 589824, 1076024, 7},
                                   {963840, 14848, 720896, 1076024, 7}});
  for (const spec::Case& c : {rows, last, half}) expect_all_draw_the_same(c, 0);
}

// A few texels on both sides of the texture's border, next to it or as far from it as there are
// any.
[[nodiscard]] spec::Case any_far(spec::Random& random) {
  constexpr int32_t kMost_texel = (1 << 15) - 4;
  spec::Case c;
  c.format = random.pick({SELVAGE_INDEX8, SELVAGE_RGB565, SELVAGE_RGBA8888});
  c.address = random.percent(75) ? SELVAGE_ADDRESS_CLAMP : SELVAGE_ADDRESS_WRAP;
  c.texture_width_texel = random.in(16, 40);
  c.texture_height_texel = random.in(16, 40);
  c.target_width_px = random.in(4, 64);
  c.target_height_px = random.in(2, 40);
  const auto corner = [&](int32_t size_texel) {
    const int32_t beyond = random.pick({0, 3, 64, 100, 128, 129, 200, 256, 300, 4096});
    const int32_t texel = random.percent(50) ? -beyond : size_texel + beyond;
    const int32_t far = random.percent(10) ? (texel < 0 ? -kMost_texel : kMost_texel) : texel;
    return far * kTexel_fx16 + random.in(-2 * kTexel_fx16, 2 * kTexel_fx16);
  };
  const int32_t u_fx16 = corner(c.texture_width_texel), v_fx16 = corner(c.texture_height_texel);
  const auto near = [&](int32_t fx16) { return fx16 + random.in(0, 2 * kTexel_fx16); };
  const int32_t right_fx8 = c.target_width_px * kPixel_fx8,
                bottom_fx8 = c.target_height_px * kPixel_fx8;
  c.vertices = {{0, 0, near(u_fx16), near(v_fx16), 1},
                {right_fx8, random.in(0, bottom_fx8), near(u_fx16), near(v_fx16), 1},
                {random.in(0, right_fx8), bottom_fx8, near(u_fx16), near(v_fx16), 1}};
  return c;
}

TEST(FineLanes, OfTexelsBeyondTheTextureAreTheirBorders) {
  for (uint64_t seed = 1; seed <= 3000; ++seed) {
    spec::Random random(seed);
    expect_all_draw_the_same(any_far(random), seed);
  }
}

}  // namespace
}  // namespace selvage::mapper
