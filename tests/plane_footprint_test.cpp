#include "mapper/plane_footprint.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "mapper/plane.h"
#include "mapper/projective_plane.h"
#include "spec/filter.h"
#include "spec/gradient.h"
#include "spec/random.h"
#include "tests/span_support.h"

namespace selvage::mapper {
namespace {

constexpr BoxSides kLeast{kLeastSide_fx8, kLeastSide_fx8}, kMost{kMostSide_fx8, kMostSide_fx8};
constexpr selvage_rect kEverywhere{-40000, -40000, 40000, 40000};

[[nodiscard]] BoxSides wanted_sides(std::span<const selvage_vertex> vertices, int32_t px,
                                    int32_t row) {
  const auto gradient = spec::gradient(vertices, px, row);
  EXPECT_TRUE(gradient);
  const spec::BoxSides sides = spec::box_sides(*gradient);
  return {sides.u_fx8, sides.v_fx8};
}

// What a kernel makes of a line: the sides between its bounds.
struct Bounds {
  double low, high;
};
[[nodiscard]] Bounds bounds_of(const FootprintLine& line, double offset_px, double weight) {
  const double changes = line.across + std::abs(line.down_start + offset_px * line.down_step);
  return {(changes - line.slack) * weight * weight, (changes + line.slack) * weight * weight};
}
[[nodiscard]] bool holds(const Bounds& bounds, int32_t side_fx8) {
  const auto ceil_of = [](double side) {
    return std::ceil(std::clamp<double>(side, kLeastSide_fx8, kMostSide_fx8));
  };
  return ceil_of(bounds.low) <= side_fx8 && side_fx8 <= ceil_of(bounds.high);
}

struct Seen {
  int least = 0, between = 0, most = 0, told_least = 0, open = 0;
};

// At both ends and in the middle of a span.
void expect_sides(std::span<const selvage_vertex> vertices, const PlaneFootprint& footprint,
                  const Span& span, Seen* seen) {
  const FootprintRow row = footprint.row(span);
  const bool is_least = footprint.is_least() || row.is_least(span.width_px());
  for (const int32_t offset : {0, span.width_px() / 2, span.width_px() - 1}) {
    const int32_t px = span.left_px + offset;
    const BoxSides wanted = wanted_sides(vertices, px, span.row);
    ASSERT_EQ(footprint.exact(px, span.row, kLeast, kMost), wanted) << px << ", " << span.row;
    const double weight = 1 / (row.denominator.start + offset * row.denominator.step);
    const Bounds u = bounds_of(row.u, offset, weight), v = bounds_of(row.v, offset, weight);
    ASSERT_TRUE(holds(u, wanted.u_fx8) && holds(v, wanted.v_fx8)) << px << ", " << span.row;
    ASSERT_TRUE(!is_least || wanted == kLeast) << px << ", " << span.row;
    ++(wanted == kLeast ? seen->least : wanted == kMost ? seen->most : seen->between);
    if (is_least) ++seen->told_least;
    if (std::ceil(u.low) != std::ceil(u.high)) ++seen->open;
  }
}

void expect_sides_of(const std::vector<selvage_vertex>& vertices, const selvage_rect& visible,
                     Seen* seen) {
  Polygon polygon;
  if (examine(vertices, &polygon) != SELVAGE_OK || polygon.affine) return;
  const selvage_rect rows{visible.left, std::max(visible.top, polygon.top_row), visible.right,
                          std::min(visible.bottom, polygon.bottom_row)};
  if (rows.top >= rows.bottom) return;
  const auto plane = ProjectivePlane::of(polygon, visible);
  if (!plane) return;
  const PlaneFootprint footprint(polygon, visible, plane->lanes());
  for (const int32_t row : {rows.top, (rows.top + rows.bottom) / 2, rows.bottom - 1}) {
    for_each_row(polygon, row, row + 1, visible.left, visible.right,
                 [&](const Edge&, const Edge&, const Span& span) {
                   expect_sides(vertices, footprint, span, seen);
                 });
  }
}

TEST(PlaneFootprint, IsTheSpecificationsForGeneratedCases) {
  Seen seen;
  for (uint64_t seed = 1; seed <= 20000; ++seed) {
    const spec::Case c = spec::generate(seed);
    expect_sides_of(c.vertices, {0, 0, c.target_width_px, c.target_height_px}, &seen);
    ASSERT_FALSE(HasFatalFailure()) << spec::print(c);
  }
  EXPECT_GT(seen.least, 1000);
  EXPECT_GT(seen.told_least, 300);
  EXPECT_GT(seen.between, 1000);
}

// Triangles with numbers as long as they may be; those that are too steep have no plane.
TEST(PlaneFootprint, IsExactAtTheEndsOfEveryRange) {
  spec::Random random(17);
  Seen seen;
  for (int i = 0; i < 6000; ++i) {
    const auto position = [&] {
      const int32_t any = random.in(SELVAGE_X_MIN, SELVAGE_X_END);
      return random.pick({int32_t{SELVAGE_X_MIN}, SELVAGE_X_END - 1, any, any});
    };
    const auto texel = [&] {
      const int32_t any = random.in(INT32_MIN, int64_t{INT32_MAX} + 1);
      return random.pick({INT32_MIN, INT32_MAX, INT32_MIN + 1, any, any});
    };
    std::vector<selvage_vertex> vertices;
    for (int k = 0; k < 3; ++k) {
      const int32_t any = random.in(1, SELVAGE_Q_MAX + 1);
      vertices.push_back({position(), position(), texel(), texel(),
                          random.pick({1, 1000, int32_t{SELVAGE_Q_MAX}, any, any})});
    }
    expect_sides_of(vertices, kEverywhere, &seen);
    ASSERT_FALSE(HasFatalFailure()) << i;
  }
  EXPECT_GT(seen.between, 1000);
  EXPECT_GT(seen.most, 0);
}

// u q = A x and q = Q + B y, from a pixel's centre on: A / Q is the side there. It is whole, or
// barely not.
TEST(PlaneFootprint, LeavesToIntegersWhatDoublesCannotDecide) {
  Seen seen;
  for (const int32_t side_fx8 : {256, 300, 4999}) {
    for (const int32_t beyond : {-1, 0, 1}) {
      constexpr int32_t kHalf = 25600, kNear = 1 << 19, kCentre = 128 + kHalf;
      const int32_t v = side_fx8 * (kHalf / 2 * 3), u = v + beyond;
      const std::vector<selvage_vertex> vertices = {{kCentre - kHalf, 128, -u, -v, kNear},
                                                    {kCentre + kHalf, 128, u, v, kNear},
                                                    {kCentre, 128 + 2 * kHalf, 0, 0, 2 * kNear}};
      expect_sides_of(vertices, {0, 0, 200, 200}, &seen);
      ASSERT_FALSE(HasFatalFailure());
    }
  }
  EXPECT_GT(seen.open, 5);
}

TEST(AffineSides, AreTheSpecificationsForGeneratedCases) {
  int least = 0, between = 0;
  for (uint64_t seed = 1; seed <= 4000; ++seed) {
    const spec::Case c = spec::generate(seed);
    Polygon polygon;
    const selvage_rect visible{0, 0, c.target_width_px, c.target_height_px};
    if (examine(c.vertices, &polygon) != SELVAGE_OK || !Plane::of(polygon, visible)) continue;
    const BoxSides sides = affine_sides(PlaneFrame::of(polygon.vertices));
    for_each_row(polygon, 0, c.target_height_px, 0, c.target_width_px,
                 [&](const Edge&, const Edge&, const Span& span) {
                   if (HasFatalFailure()) return;
                   ASSERT_EQ(wanted_sides(c.vertices, span.left_px, span.row), sides);
                   ++(sides == kLeast ? least : between);
                 });
    ASSERT_FALSE(HasFatalFailure()) << spec::print(c);
  }
  EXPECT_GT(least, 1000);
  EXPECT_GT(between, 1000);
}

}  // namespace
}  // namespace selvage::mapper
