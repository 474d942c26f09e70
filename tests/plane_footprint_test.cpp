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

[[nodiscard]] BoxSides wanted_sides(const spec::Gradient& gradient) {
  const spec::BoxSides sides = spec::box_sides(gradient);
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

// In 1/256 texel, exactly.
[[nodiscard]] spec::Rational exact_side(const spec::Rational& along_x,
                                        const spec::Rational& along_y) {
  return 256 * (abs(along_x) + abs(along_y));
}
[[nodiscard]] bool bounds_hold(const Bounds& bounds, const spec::Rational& side_fx8) {
  return bounds.low <= side_fx8 && side_fx8 <= bounds.high;
}

struct PlaneSideCounts {
  int least = 0, between = 0, most = 0, told_least = 0, open = 0, all_least = 0;
};

// At both ends and in the middle of a span.
void expect_sides(std::span<const selvage_vertex> vertices, const PlaneFootprint& footprint,
                  const Span& span, PlaneSideCounts* seen) {
  const FootprintRow row = footprint.row(span);
  const bool is_least = footprint.is_least() || row.is_least(span.width_px());
  for (const int32_t offset : {0, span.width_px() / 2, span.width_px() - 1}) {
    const int32_t px = span.left_px + offset;
    const auto gradient = spec::gradient(vertices, px, span.row);
    ASSERT_TRUE(gradient);
    const BoxSides wanted = wanted_sides(*gradient);
    ASSERT_EQ(footprint.exact(px, span.row, kLeast, kMost), wanted) << px << ", " << span.row;
    const double weight = 1 / (row.denominator.start + offset * row.denominator.step);
    const Bounds u = bounds_of(row.u, offset, weight), v = bounds_of(row.v, offset, weight);
    ASSERT_TRUE(bounds_hold(u, exact_side(gradient->u_along_x, gradient->u_along_y)))
        << px << ", " << span.row;
    ASSERT_TRUE(bounds_hold(v, exact_side(gradient->v_along_x, gradient->v_along_y)))
        << px << ", " << span.row;
    ASSERT_TRUE(!is_least || wanted == kLeast) << px << ", " << span.row;
    ++(wanted == kLeast ? seen->least : wanted == kMost ? seen->most : seen->between);
    if (is_least) ++seen->told_least;
    if (std::ceil(u.low) != std::ceil(u.high)) ++seen->open;
  }
}

// What the proof of the bound assumes of a line: as many roundings, times the most that both of its
// terms can be in the visible rectangle. What no corner of it reaches beyond is told to be least.
constexpr double kRoundings = 20;
void expect_bounds(const PlaneFootprint& footprint, const selvage_rect& rectangle,
                   const ProjectiveField& lanes, PlaneSideCounts* seen) {
  const int32_t columns = rectangle.right - lanes.first_px;
  const int32_t rows = rectangle.bottom - lanes.first_row;
  const FootprintRow first = footprint.row({lanes.first_row, lanes.first_px, rectangle.right});
  const FootprintRow end = footprint.row({rectangle.bottom, lanes.first_px, rectangle.right});
  bool is_least = true;
  for (const auto line : {&FootprintRow::u, &FootprintRow::v}) {
    const FootprintLine& top = first.*line;
    const double terms = top.across + std::abs(top.down_start) +
                         (double{1} * columns + rows) * std::abs(top.down_step);
    const double slack =
        kRoundings * static_cast<double>(lanes.error_fx32 + 1) * std::ldexp(terms, -53);
    ASSERT_NEAR(top.slack, slack, slack * 1e-9);
    const double across = std::max(top.across, (end.*line).across);
    const double right = std::abs(top.down_start + columns * top.down_step);
    const double down = std::max(std::abs(top.down_start), right);
    is_least = is_least && across + down + top.slack <= kLeastSide_fx8;
  }
  ASSERT_EQ(footprint.is_least(), is_least);
  if (is_least) ++seen->all_least;
}

void expect_sides_of(const std::vector<selvage_vertex>& vertices, const selvage_rect& visible,
                     PlaneSideCounts* seen) {
  Polygon polygon;
  if (examine(vertices, &polygon) != SELVAGE_OK || polygon.affine) return;
  const selvage_rect rows{visible.left, std::max(visible.top, polygon.top_row), visible.right,
                          std::min(visible.bottom, polygon.bottom_row)};
  if (rows.top >= rows.bottom) return;
  const auto plane = ProjectivePlane::of(polygon, visible);
  if (!plane) return;
  const PlaneFootprint footprint(polygon, visible, plane->lanes());
  const int32_t right = std::min(visible.right, polygon.right_px);
  if (right <= plane->lanes().first_px) return;
  expect_bounds(footprint, {rows.left, rows.top, right, rows.bottom}, plane->lanes(), seen);
  for (const int32_t row : {rows.top, (rows.top + rows.bottom) / 2, rows.bottom - 1}) {
    for_each_row(polygon, row, row + 1, visible.left, visible.right,
                 [&](const Edge&, const Edge&, const Span& span) {
                   expect_sides(vertices, footprint, span, seen);
                 });
  }
}

TEST(PlaneFootprint, IsTheSpecificationsForGeneratedCases) {
  PlaneSideCounts seen;
  for (uint64_t seed = 1; seed <= 20000; ++seed) {
    const spec::Case c = spec::generate(seed);
    expect_sides_of(c.vertices, {0, 0, c.target_width_px, c.target_height_px}, &seen);
    ASSERT_FALSE(HasFatalFailure()) << spec::print(c);
  }
  EXPECT_GT(seen.least, 1000);
  EXPECT_GT(seen.told_least, 300);
  EXPECT_GT(seen.all_least, 100);
  EXPECT_GT(seen.between, 1000);
}

// Triangles with numbers as long as they may be; those that are too steep have no plane.
TEST(PlaneFootprint, IsExactAtTheEndsOfEveryRange) {
  spec::Random random(17);
  PlaneSideCounts seen;
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
  PlaneSideCounts seen;
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

// (across + |down|) / d^2, at its most at either end, or at an end that is not reached.
TEST(FootprintRow, IsLeastWhereItsGreatestSideIs) {
  const FootprintLine least{100, -50, 0, 0};
  const auto is_least = [&](FootprintLine line, DividedLanes::Linear denominator, int32_t count) {
    const bool by_u = FootprintRow{line, least, denominator}.is_least(count);
    EXPECT_EQ((FootprintRow{least, line, denominator}.is_least(count)), by_u);
    return by_u;
  };
  EXPECT_TRUE(is_least({200, 56, 0, 0}, {1, 0}, 5));
  EXPECT_TRUE(is_least({200, -56, 0, 0}, {1, 0}, 5));
  EXPECT_TRUE(is_least({200, 55, 0, 1}, {1, 0}, 5));
  EXPECT_FALSE(is_least({200, 55.5, 0, 1}, {1, 0}, 5));
  EXPECT_FALSE(is_least({200.5, 56, 0, 0}, {1, 0}, 5));
  // Down to the fifth pixel and no further.
  EXPECT_TRUE(is_least({200, 52, 1, 0}, {1, 0}, 5));
  EXPECT_FALSE(is_least({200, 52, 1, 0}, {1, 0}, 6));
  EXPECT_TRUE(is_least({200, -52, -1, 0}, {1, 0}, 5));
  EXPECT_FALSE(is_least({200, -52, -1, 0}, {1, 0}, 6));
  EXPECT_FALSE(is_least({200, 57, -1, 0}, {1, 0}, 5));
  // By the least denominator, twice.
  EXPECT_TRUE(is_least({1000, 24, 0, 0}, {2, 0}, 5));
  EXPECT_FALSE(is_least({1000, 25, 0, 0}, {2, 0}, 5));
  EXPECT_TRUE(is_least({1000, 24, 0, 0}, {2, 0.25}, 5));
  EXPECT_TRUE(is_least({1000, 24, 0, 0}, {3, -0.25}, 5));
  EXPECT_FALSE(is_least({1000, 24, 0, 0}, {3, -0.25}, 6));
}

// Depth and u change down the target alone: with depths q0 and q1 in a distance of h, the side of
// row 0 is q1 (u1 - u0) / (h q0), and no side is greater. Here q1 (u1 - u0) = 256 h q0 + 1: by less
// than doubles tell above the least.
TEST(PlaneFootprint, TellsTheLeastFromWhatIsBarelyLarger) {
  constexpr int32_t kDown = 1 << 22, kNear = 4603037, kFar = 16700629, kChange = 295945341;
  static_assert(int64_t{kFar} * kChange == int64_t{256} * kDown * kNear + 1);
  for (const int32_t less : {0, 1, 1000}) {
    const std::vector<selvage_vertex> vertices = {
        {0, 128, 0, 0, kNear}, {5000, 128, 0, 0, kNear}, {0, 128 + kDown, kChange - less, 0, kFar}};
    Polygon polygon;
    ASSERT_EQ(examine(vertices, &polygon), SELVAGE_OK);
    constexpr selvage_rect kFirstRow{0, 0, 20, 1};
    const auto plane = ProjectivePlane::of(polygon, kFirstRow);
    ASSERT_TRUE(plane);
    const PlaneFootprint footprint(polygon, kFirstRow, plane->lanes());
    EXPECT_EQ(footprint.exact(3, 0, kLeast, kMost), (BoxSides{less == 0 ? 257 : 256, 256}));
    EXPECT_EQ(footprint.is_least(), less != 0);
    EXPECT_EQ(footprint.row({0, 0, 19}).is_least(19), less != 0);
  }
}

TEST(AffineSides, AreTheSpecificationsForGeneratedCases) {
  int least = 0, between = 0;
  for (uint64_t seed = 1; seed <= 4000; ++seed) {
    const spec::Case c = spec::generate(seed);
    Polygon polygon;
    const selvage_rect visible{0, 0, c.target_width_px, c.target_height_px};
    if (examine(c.vertices, &polygon) != SELVAGE_OK) continue;
    if (!Plane::of(polygon, part_of(polygon, visible))) continue;
    const BoxSides sides = affine_sides(PlaneFrame::of(polygon.vertices));
    for_each_row(polygon, 0, c.target_height_px, 0, c.target_width_px,
                 [&](const Edge&, const Edge&, const Span& span) {
                   if (HasFatalFailure()) return;
                   const auto gradient = spec::gradient(c.vertices, span.left_px, span.row);
                   ASSERT_TRUE(gradient);
                   ASSERT_EQ(wanted_sides(*gradient), sides);
                   ++(sides == kLeast ? least : between);
                 });
    ASSERT_FALSE(HasFatalFailure()) << spec::print(c);
  }
  EXPECT_GT(least, 1000);
  EXPECT_GT(between, 1000);
}

}  // namespace
}  // namespace selvage::mapper
