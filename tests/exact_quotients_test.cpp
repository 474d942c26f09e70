// Where near-ties are many, vector kernels step exact quotients: pixels whose remainders are 0, or
// a unit more or less, and polygons that are near-ties and ties nearly everywhere.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "mapper/vector/kernel.h"
#include "spec/random.h"
#include "spec/vertex_units.h"
#include "tests/kernel_support.h"
#include "tests/span_support.h"
#include "tests/whole.h"

namespace selvage::mapper {
namespace {

using spec::kTexel_fx16;

// The x for which a x = b modulo m; 0 where a and m have a common divisor.
[[nodiscard]] int128 solved(int128 a, int128 b, int128 m) {
  mpz_class x;
  if (mpz_invert(x.get_mpz_t(), whole(a).get_mpz_t(), whole(m).get_mpz_t()) == 0) return 0;
  return static_cast<int128>(bits_of(whole(b) * x % whole(m)));
}

// A row whose coordinates are whole at one pixel each, or miss that by the least there is.
struct LeastMissRow {
  Span span;
  EdgePoint left, right;
};

[[nodiscard]] LeastMissRow any_least_miss_row(spec::Random& random) {
  const int32_t width_px = random.in(20, 65);
  const int64_t q = random.percent(50) ? 1 : random.in(1, 4096);
  const int64_t beside = random.in(0, 128) * 2 + 1;  // odd, so that distances are
  const int64_t length = 256 * (width_px - 1) + beside + 1 + random.in(0, 256);
  const int128 divisor = int128{kTexel_fx16} * q * length;
  const auto ends = [&] {
    const int64_t left = random.in(-100, 100) * kTexel_fx16 * q + random.in(0, 1000);
    const int64_t distance = 256 * random.in(0, width_px) + beside;
    const int128 change = solved(distance, random.in(-1, 2) - int128{left} * length, divisor);
    return std::pair(int128{left}, left + change);
  };
  const auto [u_left, u_right] = ends();
  const auto [v_left, v_right] = ends();
  const int64_t x = kHalfPixel - beside;
  return {{0, 0, width_px}, {1, x, u_left, v_left, q}, {1, x + length, u_right, v_right, q}};
}

[[nodiscard]] uint32_t colour_of(int32_t texel) {
  return static_cast<uint32_t>(texel) * 2654435761U;
}

[[nodiscard]] std::vector<uint32_t> expected(const SpanMap& map, int32_t width_px) {
  std::vector<uint32_t> row;
  for (int32_t px = 0; px < width_px; ++px) {
    const int32_t s = static_cast<int32_t>(floor_of(map.u_numerator(px), map.denominator(px))) &
                      (kRowTexture_texel - 1);
    const int32_t t = static_cast<int32_t>(floor_of(map.v_numerator(px), map.denominator(px))) &
                      (kRowTexture_texel - 1);
    row.push_back(colour_of(t * kRowTexture_texel + s));
  }
  return row;
}

// By lanes that are most of a texel low: nearly all pixels are in doubt.
[[nodiscard]] std::vector<uint32_t> drawn_by_low_lanes(const SpanMap& map, const Span& span,
                                                       const std::vector<uint32_t>& texels,
                                                       selvage_kernel kernel) {
  constexpr uint32_t kLag_fx32 = 0xF0000000;
  std::vector<uint32_t> pixels(static_cast<size_t>(span.width_px()));
  const Surface surface{{pixels.data(), span.width_px(), 1, span.width_px() * 4, SELVAGE_RGBA8888},
                        {texels.data(), kRowTexture_texel, kRowTexture_texel, kRowTexture_texel * 4,
                         SELVAGE_RGBA8888, SELVAGE_LAYOUT_ROWS, nullptr},
                        SELVAGE_ADDRESS_WRAP};
  AffineField field = AffineLanes(map, span).field(span);
  field.start.u_fx32 -= kLag_fx32;
  field.start.v_fx32 -= kLag_fx32;
  field.margin_fx32 += kLag_fx32;
  const Kernels& kernels = kernel == SELVAGE_KERNEL_SCALAR
                               ? scalar_kernels(SELVAGE_FILTER_NEAREST)
                               : *vector_kernels(kernel, SELVAGE_FILTER_NEAREST);
  kernels.draw_affine({one_span(span), field, kFarApart, ExactMap(map)}, surface);
  return pixels;
}

TEST(ExactQuotients, TellWholeNumbersFromTheLeastMiss) {
  std::vector<uint32_t> texels;
  for (int32_t i = 0; i < kRowTexture_texel * kRowTexture_texel; ++i) {
    texels.push_back(colour_of(i));
  }
  spec::Random random(1);
  for (int i = 0; i < 5000; ++i) {
    const LeastMissRow row = any_least_miss_row(random);
    const SpanMap map(row.left, row.right);
    const std::vector<uint32_t> right = expected(map, row.span.width_px());
    for (const selvage_kernel kernel : usable_kernels()) {
      ASSERT_EQ(drawn_by_low_lanes(map, row.span, texels, kernel), right)
          << "kernel " << kernel << ", row " << i;
    }
  }
}

// u = x num / den + off over a triangle with such legs, v likewise; each corner maybe a unit off.
struct Legs {
  int32_t x_px, y_px;
};

[[nodiscard]] std::vector<int32_t> coordinate(spec::Random& random, const Legs& legs) {
  const int32_t den = random.pick({1, 1, 2, 3, 5, 7, 16, 100});
  const int64_t num_x = random.in(-3, 4), num_y = random.in(-3, 4);
  const int64_t off_fx16 =
      random.in(-20, 100) * kTexel_fx16 + random.pick({0, 1 << 15, 3 << 14, 10923, 21845});
  const auto at = [&](int64_t x_px, int64_t y_px) {
    const int64_t nudge = random.percent(40) ? random.in(-2, 3) : 0;
    return static_cast<int32_t>(off_fx16 + (x_px * num_x + y_px * num_y) * kTexel_fx16 / den +
                                nudge);
  };
  return {at(0, 0), at(legs.x_px, 0), at(0, legs.y_px)};
}

[[nodiscard]] spec::Case any_tie_case(spec::Random& random) {
  spec::Case c;
  c.format = random.pick({SELVAGE_INDEX8, SELVAGE_RGB565, SELVAGE_RGBA8888});
  c.address = random.pick({SELVAGE_ADDRESS_CLAMP, SELVAGE_ADDRESS_WRAP});
  c.target_width_px = random.percent(70) ? random.in(1, 130) : random.in(130, 1101);
  c.target_height_px = random.in(1, 40);
  c.texture_width_texel = random.pick({1, 7, 16, 33, 64, 100});
  c.texture_height_texel = random.pick({1, 7, 16, 33, 64, 100});
  c.layout = random.pick({spec::Layout::kGiven, spec::Layout::kGiven, spec::Layout::kTiled});
  const auto leg_px = [&] {
    const int32_t most_px = 10922;  // three texels a pixel fit the coordinates
    return random.percent(50) ? most_px - random.in(0, 4) : random.in(1, most_px);
  };
  const Legs legs{random.percent(50) ? leg_px() : random.in(1, 140), leg_px()};
  const std::vector<int32_t> u = coordinate(random, legs), v = coordinate(random, legs);
  const int32_t x = legs.x_px * SELVAGE_SUBPIXELS, y = legs.y_px * SELVAGE_SUBPIXELS;
  c.vertices = {{0, 0, u[0], v[0], 1}, {x, 0, u[1], v[1], 1}, {0, y, u[2], v[2], 1}};
  if (random.percent(20)) {
    for (selvage_vertex& vertex : c.vertices) std::swap(vertex.x, vertex.y);
  }
  return c;
}

// A quad that no plane holds, of which a row's centres lie below the top edge by a hair: along that
// row coordinates change by less than a unit of 2^-32 texel a pixel, and lanes, whose steps are
// lowered by half a unit, may fall where they rise.
[[nodiscard]] spec::Case any_case_of_least_slopes(spec::Random& random) {
  spec::Case c;
  c.format = random.pick({SELVAGE_INDEX8, SELVAGE_RGB565, SELVAGE_RGBA8888});
  c.address = random.pick({SELVAGE_ADDRESS_CLAMP, SELVAGE_ADDRESS_WRAP});
  c.target_width_px = random.in(60, 140);
  c.target_height_px = random.in(1, 4);
  c.texture_width_texel = random.pick({8, 13, 32});
  c.texture_height_texel = random.pick({3, 8, 32});
  const int32_t right = c.target_width_px * SELVAGE_SUBPIXELS - random.in(0, 256);
  const int32_t top = kHalfPixel - random.in(1, 4);
  const int32_t bottom = random.in(4, 40) * SELVAGE_SUBPIXELS;
  const int32_t u = random.in(-2, 10) * kTexel_fx16, v = random.in(-2, 10) * kTexel_fx16;
  const auto beside = [&](int32_t whole_fx16) { return whole_fx16 + random.in(-1, 2); };
  c.vertices = {{0, top, u, v, 1}, {right, top, u, v, 1}};
  for (const int32_t x : {right, 0}) {
    const int32_t bottom_u = beside(u), bottom_v = beside(v);
    c.vertices.push_back({x, bottom, bottom_u, bottom_v, 1});
  }
  return c;
}

TEST(ExactQuotients, StepUpWhereLanesStepDown) {
  for (uint64_t seed = 1; seed <= 3000; ++seed) {
    spec::Random random(seed);
    expect_drawn_alike(any_case_of_least_slopes(random), seed);
    ASSERT_FALSE(HasFatalFailure());
  }
}

// The same, by hand: v reaches a whole texel beyond the last pixel.
TEST(ExactQuotients, StepUpToTheEdgeOfATexel) {
  spec::Case c;
  c.format = SELVAGE_INDEX8;
  c.address = SELVAGE_ADDRESS_CLAMP;
  c.target_width_px = 65;
  c.target_height_px = 1;
  c.texture_width_texel = 8;
  c.texture_height_texel = 3;
  c.vertices = {{0, 127, 0, 65536, 1},
                {16640, 127, 0, 65536, 1},
                {16640, 4223, 0, 65536, 1},
                {0, 4223, 0, 65535, 1}};
  expect_drawn_alike(c, 0);
}

// A block of seeds.
class ExactQuotientsOf : public testing::TestWithParam<uint64_t> {};

TEST_P(ExactQuotientsOf, DrawPolygonsAsTheScalarKernelDoes) {
  constexpr uint64_t kSeeds = 400;
  for (uint64_t seed = GetParam() * kSeeds + 1; seed <= (GetParam() + 1) * kSeeds; ++seed) {
    spec::Random random(seed);
    const spec::Case c = any_tie_case(random);
    const spec::Canvas scalar = drawing_of(c, SELVAGE_KERNEL_SCALAR);
    for (const selvage_kernel kernel : usable_kernels()) {
      ASSERT_TRUE(drawing_of(c, kernel) == scalar)
          << "kernel " << kernel << ", seed " << seed << "\n"
          << spec::print(c);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Block, ExactQuotientsOf, testing::Range(uint64_t{0}, uint64_t{10}));

}  // namespace
}  // namespace selvage::mapper
