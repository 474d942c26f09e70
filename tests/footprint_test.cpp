#include "mapper/footprint.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <vector>

#include "spec/filter.h"
#include "spec/gradient.h"
#include "spec/random.h"
#include "tests/span_support.h"

namespace selvage::mapper {
namespace {

struct SideCounts {
  int least = 0, between = 0, most = 0;
};

// At both ends and in the middle of a span: the sides of the specification.
void expect_exact_sides(std::span<const selvage_vertex> vertices, const Edge& left,
                        const Edge& right, const Span& span, SideCounts* seen) {
  const Footprint footprint(left.at(span.row), left.change(), right.at(span.row), right.change());
  for (const int32_t px : {span.left_px, span.left_px + span.width_px() / 2, span.right_px - 1}) {
    const auto gradient = spec::gradient(vertices, px, span.row);
    ASSERT_TRUE(gradient);
    const spec::BoxSides wanted = spec::box_sides(*gradient);
    const BoxSides sides = footprint.at(px);
    ASSERT_EQ(sides.u_fx8, wanted.u_fx8) << "pixel " << px << ", row " << span.row;
    ASSERT_EQ(sides.v_fx8, wanted.v_fx8) << "pixel " << px << ", row " << span.row;
    ++(sides.u_fx8 == kLeastSide_fx8  ? seen->least
       : sides.u_fx8 == kMostSide_fx8 ? seen->most
                                      : seen->between);
  }
}

void expect_exact_sides_of_generated_cases(int seeds) {
  SideCounts seen;
  for (uint64_t seed = 1; seed <= static_cast<uint64_t>(seeds); ++seed) {
    const spec::Case c = spec::generate(seed);
    Polygon polygon;
    if (examine(c.vertices, &polygon) != SELVAGE_OK) continue;
    for_each_row(polygon, 0, c.target_height_px, 0, c.target_width_px,
                 [&](const Edge& left, const Edge& right, const Span& span) {
                   if (testing::Test::HasFatalFailure()) return;
                   expect_exact_sides(c.vertices, left, right, span, &seen);
                 });
    ASSERT_FALSE(testing::Test::HasFatalFailure()) << spec::print(c);
  }
  EXPECT_GT(seen.least, seeds * 5 / 3);
  EXPECT_GT(seen.between, seeds * 5 / 3);
  EXPECT_GT(seen.most, seeds / 60);
}

TEST(Footprint, IsTheSpecificationsForGeneratedCases) {
  expect_exact_sides_of_generated_cases(600);
}
TEST(FootprintAtLength, IsTheSpecificationsForGeneratedCases) {
  expect_exact_sides_of_generated_cases(3000);
}

// Numbers as long as they may be.
TEST(Footprint, IsExactAtTheEndsOfEveryRange) {
  spec::Random random(7);
  SideCounts seen;
  for (int i = 0; i < 3000; ++i) {
    const auto position = [&] {
      const int32_t any = random.in(SELVAGE_X_MIN, SELVAGE_X_END);
      return random.pick({int32_t{SELVAGE_X_MIN}, SELVAGE_X_END - 1, SELVAGE_X_MIN + 1, any, any});
    };
    const auto texel = [&] {
      const int32_t any = random.in(INT32_MIN, int64_t{INT32_MAX} + 1);
      return random.pick({INT32_MIN, INT32_MAX, INT32_MIN + 1, any, any});
    };
    std::vector<selvage_vertex> vertices;
    const bool perspective = random.percent(70);
    for (int k = 0; k < (random.percent(50) ? 3 : 4); ++k) {
      const int32_t x = position(), y = position(), u = texel(), v = texel();
      const int32_t any = random.in(1, SELVAGE_Q_MAX + 1);
      const int32_t q = random.pick({1, int32_t{SELVAGE_Q_MAX}, SELVAGE_Q_MAX - 1, any});
      vertices.push_back({x, y, u, v, perspective ? q : 1});
    }
    Polygon polygon;
    if (examine(vertices, &polygon) != SELVAGE_OK || polygon.top_row >= polygon.bottom_row)
      continue;
    const int32_t row = random.in(polygon.top_row, polygon.bottom_row);
    for (const int32_t at : {polygon.top_row, row, polygon.bottom_row - 1}) {
      for_each_row(polygon, at, at + 1, INT32_MIN, INT32_MAX,
                   [&](const Edge& left, const Edge& right, const Span& span) {
                     expect_exact_sides(vertices, left, right, span, &seen);
                   });
      ASSERT_FALSE(HasFatalFailure()) << i;
    }
  }
  EXPECT_GT(seen.least, 300);
  EXPECT_GT(seen.between, 1000);
  EXPECT_GT(seen.most, 50);
}

// Sides that are whole, or a little more: by less than doubles tell.
TEST(Footprint, IsExactWhereDoublesCannotDecide) {
  constexpr int64_t kWidth = 1 << 23, kQ = SELVAGE_Q_MAX;
  for (const int32_t side_fx8 : {300, 301, 1 << 20, kMostSide_fx8 - 1}) {
    for (const int beyond : {0, 1}) {
      const int128 across = int128{side_fx8} * kWidth * kQ + beyond;
      const EdgePoint left{1, 0, 0, 0, kQ}, right{1, kWidth, across, across - beyond, kQ};
      const BoxSides sides = Footprint(left, {}, right, {}).at(5);
      EXPECT_EQ(sides, (BoxSides{side_fx8 + beyond, side_fx8}));
      EXPECT_NE(sides, (BoxSides{side_fx8 + beyond, side_fx8 + 1}));
      EXPECT_NE(sides, (BoxSides{side_fx8 + 1 - beyond, side_fx8}));
    }
  }
}

// Sides that are whole, with terms of either sign in either direction, which cancel or add up.
TEST(Footprint, IsExactWhereTermsOfEitherSignMakeAWholeSide) {
  spec::Random random(11);
  for (int i = 0; i < 20000; ++i) {
    const auto term = [&] { return random.in(-(1 << 20), (1 << 20) + 1); };
    const int32_t width_px = random.in(1, 30), px = random.in(0, width_px), q = random.in(1, 40);
    // u = (across x + down y) / 256 and likewise v, in 1/65536 texel of 1/256 px; both edges
    // upright.
    const int64_t across = term(), down = term(), across_v = term(), down_v = term();
    const int64_t height = random.in(1, 5000), x_px = random.in(-9, 9);
    const auto at = [&](int64_t at_px) {
      const int64_t x = (x_px + at_px) * 256;
      return EdgePoint{height, x * height, int128{across} * x * q * height,
                       int128{across_v} * x * q * height, q * height};
    };
    const EdgeChange change{0, down * height * q, down_v * height * q, 0};
    const BoxSides sides =
        Footprint(at(0), change, at(width_px), change).at(static_cast<int32_t>(x_px) + px);
    const auto side = [](int64_t a, int64_t b) {
      return static_cast<int32_t>(
          std::clamp<int64_t>(std::abs(a) + std::abs(b), kLeastSide_fx8, kMostSide_fx8));
    };
    ASSERT_EQ(sides, (BoxSides{side(across, down), side(across_v, down_v)}))
        << i << ": " << across << " " << down << " " << across_v << " " << down_v;
  }
}

// Sides that are whole where depth varies along x and y: u = c + (s (x - x0) + t (y - y0)) q0 / q,
// whose changes at (x0, y0) are s and t while the terms of both are as large as c makes them.
TEST(Footprint, IsExactWhereTermsInPerspectiveCancelToAWholeSide) {
  spec::Random random(13);
  constexpr int64_t kMost_px = 30;
  for (int i = 0; i < 20000; ++i) {
    const auto far = [&](int bits) { return random.in(-(1 << bits), (1 << bits) + 1); };
    const auto px = static_cast<int32_t>(random.in(0, kMost_px)), side_bits = random.in(1, 20);
    const int64_t s = far(side_bits), t = far(side_bits), c = far(random.in(1, 30));
    const int64_t steep = far(random.in(1, 10)), steep_y = far(random.in(1, 10));
    const int64_t q0 = std::abs(steep) * kMost_px * 256 + random.in(1, 1 << 20);
    const int64_t height = random.in(1, 3000), x0 = centre_fx8(px);
    const auto at = [&](int64_t x) {
      const int64_t q = q0 + steep * (x - x0);
      const int128 uq = int128{c} * q + int128{s} * (x - x0) * q0;
      return EdgePoint{height, x * height, uq * height, -uq * height, q * height};
    };
    const int64_t uq_change = (c * steep_y + t * q0) * height;
    const EdgeChange change{0, uq_change, -uq_change, steep_y * height};
    const BoxSides sides = Footprint(at(0), change, at(kMost_px * 256), change).at(px);
    const auto wanted = static_cast<int32_t>(
        std::clamp<int64_t>(std::abs(s) + std::abs(t), kLeastSide_fx8, kMostSide_fx8));
    ASSERT_EQ(sides, (BoxSides{wanted, wanted}))
        << i << ": " << s << " " << t << " " << c << " " << steep << " " << steep_y << " " << q0;
  }
}

}  // namespace
}  // namespace selvage::mapper
