// Where the vector kernels permute the rows of small windows: every size of texture about a
// window's, every angle, slopes up to a texel a pixel, seams and ends of the texture in the middle
// of vectors.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <utility>

#include "mapper/image.h"
#include "spec/random.h"
#include "spec/vertex_units.h"
#include "tests/kernel_support.h"

namespace selvage::mapper {
namespace {

using spec::kPixel_fx8;
using spec::kTexel_fx16;

// An angle in degrees and a scale in texels a pixel that make ties, or any.
struct Similarity {
  double angle, scale;
};

[[nodiscard]] Similarity any_similarity(spec::Random& random) {
  static constexpr double kAngles[] = {0, 45, 90, 135, 180, 225, 270, 315};
  static constexpr double kScales[] = {1, 1, 0.5, 0.25, 1.0 / 3, 0.2, 1.0 / 16, 1.0 / 4096};
  const bool ties = random.percent(40);
  const double angle = ties ? random.pick(kAngles) : random.in(0, 360000) / 1000.0;
  const double scale = random.percent(50) ? random.pick(kScales) : random.in(1, 1100) / 1000.0;
  return {angle * std::numbers::pi / 180, scale};
}

// u and v of points of the target under one turned and scaled map, rounded to 1/65536.
[[nodiscard]] spec::Case turned_and_scaled(uint64_t seed) {
  static constexpr selvage_format kFormats[] = {SELVAGE_INDEX8, SELVAGE_RGB565, SELVAGE_RGBA8888};
  static constexpr int32_t kSizes[] = {1, 4, 7, 8, 9, 15, 16, 17, 24, 31, 32, 33, 64, 100, 256};
  spec::Random random(seed);
  spec::Case c;
  c.format = random.pick(kFormats);
  c.address = random.percent(50) ? SELVAGE_ADDRESS_CLAMP : SELVAGE_ADDRESS_WRAP;
  c.target_width_px = random.in(20, 120);
  c.target_height_px = random.in(1, 40);
  c.texture_width_texel = random.pick(kSizes);
  c.texture_height_texel = random.pick(kSizes);
  c.padding_px = random.in(0, 4);
  c.flip_target = random.percent(20);
  c.flip_texture = random.percent(20);
  const Similarity map = any_similarity(random);
  const double cos = std::cos(map.angle) * map.scale, sin = std::sin(map.angle) * map.scale;
  const double u_texel = random.in(-20, c.texture_width_texel + 20) + random.in(0, 5) / 4.0;
  const double v_texel = random.in(-20, c.texture_height_texel + 20) + random.in(0, 5) / 4.0;
  const bool big = random.percent(50);
  for (int corner = 0; corner < 3; ++corner) {
    const int32_t x_fx8 = big ? random.in(-2000, 32000) : random.in(0, 24 * 256);
    const int32_t y_fx8 = big ? random.in(-2000, 12000) : random.in(0, 24 * 256);
    const double x_px = x_fx8 / 256.0, y_px = y_fx8 / 256.0;
    const auto fx16 = [](double texel) { return static_cast<int32_t>(std::lround(texel * 65536)); };
    c.vertices.push_back({x_fx8, y_fx8, fx16(u_texel + x_px * cos - y_px * sin),
                          fx16(v_texel + x_px * sin + y_px * cos), 1});
  }
  return c;
}

// u goes on by a hair less than a texel a pixel, from a hair above whole ones, so that lanes fall
// behind: a window by such lanes holds not all that they are raised to. The hair is what one
// far-away corner is off by; the opposite edge is near the target's end.
[[nodiscard]] spec::Case raised_beyond_windows(uint64_t seed) {
  spec::Case c = turned_and_scaled(seed);
  spec::Random random(seed);
  c.target_width_px = random.in(100, 160);
  const int32_t sign = random.percent(50) ? 1 : -1;
  const int32_t end_fx8 =
      (c.target_width_px - random.in(0, 10)) * kPixel_fx8 + random.in(0, kPixel_fx8);
  const int32_t far_fx8 = -random.in(25000, 32000) * kPixel_fx8;
  const int32_t u_texel = random.in(-20, c.texture_width_texel + 20);
  const double slope = random.in(-kTexel_fx16, kTexel_fx16 + 1) / static_cast<double>(kTexel_fx16);
  c.vertices = {{far_fx8, random.in(-5000, 5000), 0, 0, 1},
                {end_fx8, -random.in(5000, 9000), 0, 0, 1},
                {end_fx8 + random.in(-9, 10), random.in(20000, 30000), 0, 0, 1}};
  for (selvage_vertex& vertex : c.vertices) {
    const int32_t from_centre_fx8 = vertex.x - kPixel_fx8 / 2;
    vertex.u = u_texel * kTexel_fx16 + sign * from_centre_fx8 * (kTexel_fx16 / kPixel_fx8);
    vertex.v =
        static_cast<int32_t>(std::lround((from_centre_fx8 / 4 + vertex.y) * slope * kPixel_fx8));
  }
  c.vertices[0].u += 1;
  return c;
}

// A small upright rectangle whose first pixel's centre shows the very corner of a texel, from where
// u and v rise or fall by less than a texel a pixel: a window that is too small by a texel on the
// side that they leave lacks it.
[[nodiscard]] spec::Case from_a_texels_corner(uint64_t seed) {
  spec::Case c = turned_and_scaled(seed);
  spec::Random random(seed);
  const int32_t width_px = random.in(1, 33), height_px = random.in(1, 20);
  const int32_t left_px = random.in(0, 8), top_px = random.in(0, 8);
  // In 1/16 texel a pixel, so that coordinates are exact.
  const auto slope = [&] { return random.percent(30) ? 0 : random.in(-16, 17); };
  const int32_t ux = slope(), uy = slope(), vx = slope(), vy = slope();
  const int32_t s = random.in(-20, c.texture_width_texel + 20);
  const int32_t t = random.in(-20, c.texture_height_texel + 20);
  c.vertices.clear();
  for (const auto& [right, below] : {std::pair(0, 0), {1, 0}, {1, 1}, {0, 1}}) {
    const int32_t x = right * width_px * kPixel_fx8, y = below * height_px * kPixel_fx8;
    // From the first pixel's centre, half a pixel to the right and below.
    const int32_t dx = x - kPixel_fx8 / 2, dy = y - kPixel_fx8 / 2;
    constexpr int32_t kUnit = kTexel_fx16 / 16 / kPixel_fx8;
    c.vertices.push_back({x + left_px * kPixel_fx8, y + top_px * kPixel_fx8,
                          s * kTexel_fx16 + (dx * ux + dy * uy) * kUnit,
                          t * kTexel_fx16 + (dx * vx + dy * vy) * kUnit, 1});
  }
  return c;
}

// An upright rectangle along whose sides lie as many texels as some window has columns and rows,
// one more or fewer, with nothing between them and the rectangle's ends: near an end of the texture
// a window that is thought to have more rows than it has begins too early for the last of them.
[[nodiscard]] spec::Case that_fills_a_window(uint64_t seed) {
  static constexpr int32_t kColumns[] = {4, 8, 16}, kRows[] = {4, 8, 10, 20};
  spec::Case c = turned_and_scaled(seed);
  spec::Random random(seed);
  const int32_t columns = random.pick(kColumns) + random.in(-1, 2);
  const int32_t rows = random.pick(kRows) + random.in(-1, 2);
  c.texture_width_texel = std::max(columns, 16) + random.in(0, 4);
  c.texture_height_texel = rows + random.in(0, 8);
  const auto first = [&](int32_t texels, int32_t size_texel) {
    return random.pick({0, size_texel - texels, size_texel - texels - random.in(0, 3), -1});
  };
  const int32_t s = first(columns, c.texture_width_texel), t = first(rows, c.texture_height_texel);
  const int32_t width_px = random.in(columns, 65), height_px = random.in(rows, 2 * rows);
  c.target_width_px = width_px + 8;
  c.target_height_px = height_px + 8;
  const int32_t left_px = random.in(0, 8), top_px = random.in(0, 8);
  c.vertices.clear();
  for (const auto& [right, below] : {std::pair(0, 0), {1, 0}, {1, 1}, {0, 1}}) {
    const auto at = [](int32_t texel, int32_t texels, int32_t end) {
      return texel * kTexel_fx16 + end * (texels * kTexel_fx16 - 1);
    };
    c.vertices.push_back({(left_px + right * width_px) * kPixel_fx8,
                          (top_px + below * height_px) * kPixel_fx8, at(s, columns, right),
                          at(t, rows, below), 1});
  }
  return c;
}

// A tall polygon of few texels, at most four times as wide as the widest vector, affine or not;
// rows of the target as far apart as makes blocks of them of every size.
[[nodiscard]] spec::Case drawn_in_blocks(uint64_t seed) {
  static constexpr int32_t kPitches_bytes[] = {1024, 2048, 4096, 8192, 4096 + 64, 12288};
  constexpr int32_t kWidest_px = 64;
  spec::Case c = turned_and_scaled(seed);
  spec::Random random(seed);
  const auto pixel_bytes = static_cast<int32_t>(bytes_per_pixel(c.format));
  c.target_width_px = kWidest_px + 16;
  c.target_height_px = 150;
  c.padding_px = random.pick(kPitches_bytes) / pixel_bytes - c.target_width_px;
  const double angle = any_similarity(random).angle, scale = random.in(1, 60) / 1000.0;
  const int32_t s = random.in(0, c.texture_width_texel), t = random.in(0, c.texture_height_texel);
  const int32_t left_px = random.in(0, 16), q = random.in(50, 200);
  const bool affine = random.percent(50);
  c.vertices.clear();
  for (int corner = 0; corner < 3; ++corner) {
    const int32_t x = random.in(left_px * kPixel_fx8, (left_px + kWidest_px) * kPixel_fx8 + 1);
    const int32_t y = random.in(0, c.target_height_px * kPixel_fx8 + 1);
    const auto turned = [&](double a, double b) {
      return static_cast<int32_t>(
          std::lround((a * x + b * y) * scale * (kTexel_fx16 / kPixel_fx8)));
    };
    c.vertices.push_back({x, y, s * kTexel_fx16 + turned(std::cos(angle), -std::sin(angle)),
                          t * kTexel_fx16 + turned(std::sin(angle), std::cos(angle)),
                          affine ? q : q + random.in(0, 10)});
  }
  return c;
}

// A block of seeds.
class Window : public testing::TestWithParam<uint64_t> {};

TEST_P(Window, EveryKernelDrawsWhatTheScalarOneDraws) {
  constexpr uint64_t kSeeds = 500;
  for (uint64_t seed = GetParam() * kSeeds + 1; seed <= (GetParam() + 1) * kSeeds; ++seed) {
    ASSERT_NO_FATAL_FAILURE(expect_drawn_alike(turned_and_scaled(seed), seed));
  }
}

TEST_P(Window, EveryKernelDrawsTexelsRaisedBeyondIt) {
  constexpr uint64_t kSeeds = 100;
  for (uint64_t seed = GetParam() * kSeeds + 1; seed <= (GetParam() + 1) * kSeeds; ++seed) {
    ASSERT_NO_FATAL_FAILURE(expect_drawn_alike(raised_beyond_windows(seed), seed));
  }
}

TEST_P(Window, EveryKernelDrawsFromATexelsCorner) {
  constexpr uint64_t kSeeds = 200;
  for (uint64_t seed = GetParam() * kSeeds + 1; seed <= (GetParam() + 1) * kSeeds; ++seed) {
    ASSERT_NO_FATAL_FAILURE(expect_drawn_alike(from_a_texels_corner(seed), seed));
  }
}

TEST_P(Window, EveryKernelDrawsWhatFillsIt) {
  constexpr uint64_t kSeeds = 200;
  for (uint64_t seed = GetParam() * kSeeds + 1; seed <= (GetParam() + 1) * kSeeds; ++seed) {
    ASSERT_NO_FATAL_FAILURE(expect_drawn_alike(that_fills_a_window(seed), seed));
  }
}

TEST_P(Window, EveryKernelDrawsItInBlocksOfRows) {
  constexpr uint64_t kSeeds = 25;
  for (uint64_t seed = GetParam() * kSeeds + 1; seed <= (GetParam() + 1) * kSeeds; ++seed) {
    ASSERT_NO_FATAL_FAILURE(expect_drawn_alike(drawn_in_blocks(seed), seed));
  }
}

INSTANTIATE_TEST_SUITE_P(Block, Window, testing::Range(uint64_t{0}, uint64_t{40}));

}  // namespace
}  // namespace selvage::mapper
