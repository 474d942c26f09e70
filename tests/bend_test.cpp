// How rows bend, in double, held against the exact bound of the specification.
#include "mapper/bend.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "mapper/polygon.h"
#include "mapper/projective_plane.h"
#include "mapper/span_walk.h"
#include "mapper/tolerance.h"
#include "spec/exact.h"
#include "spec/random.h"
#include "spec/tolerance.h"

namespace selvage::mapper {
namespace {

using spec::Rational;

// Of any size, depth and place in the texture.
[[nodiscard]] std::vector<selvage_vertex> random_vertices(spec::Random& random, int count) {
  const int32_t size_fx8 = 1 << random.in(10, 20), texels_fx16 = 1 << random.in(4, 30);
  const int32_t nearest = 1 << random.in(8, 20), deeper = nearest >> random.in(0, 12);
  std::vector<selvage_vertex> vertices;
  for (int i = 0; i < count; ++i) {
    const auto texel_fx16 = [&] { return random.in(-texels_fx16, texels_fx16); };
    vertices.push_back({random.in(-size_fx8, size_fx8), random.in(-size_fx8, size_fx8),
                        texel_fx16(), texel_fx16(), nearest + random.in(0, deeper)});
  }
  return vertices;
}

// A slope's terms, without their signs, in the rows [0, rows].
[[nodiscard]] double terms(const ProjectiveField& field, double rows) {
  const auto most = [&](const ProjectiveField::Form& line) {
    return std::abs(line.start) + rows * std::abs(line.step_y);
  };
  const ProjectiveField::Form& d = field.denominator;
  const auto of = [&](const ProjectiveField::Form& n) {
    return std::abs(n.step_x) * most(d) + std::abs(d.step_x) * most(n);
  };
  return std::max(of(field.u_fx32), of(field.v_fx32));
}

// A chord of a pixel is off by no less than the specification says, and by hardly more: by 2^-22
// of it, and by what is added for what the slope's terms are off by.
void expect_chord_bound(const RowBend& row, double slope_terms, const spec::ScanLine& line) {
  const Chords chords(row);
  const Rational exact_fx16 = spec::chord_bound(line, 1) * SELVAGE_SUBTEXELS;
  const Rational bound_fx16 = Rational(chords.one_px_fx16) / Rational(chords.cube);
  const Chords error({slope_terms * 0x1p-48, row.turn, row.least_denominator});
  EXPECT_GE(bound_fx16, exact_fx16);
  EXPECT_LE(bound_fx16, exact_fx16 * Rational(1 + 0x1p-22) +
                            Rational(error.one_px_fx16) / Rational(error.cube));
}

TEST(Bend, OfAPlaneIsThatOfTheSpecification) {
  int rows = 0;
  for (uint64_t seed = 1; seed <= 600; ++seed) {
    spec::Random random(seed);
    const std::vector<selvage_vertex> vertices = random_vertices(random, 3);
    Polygon polygon;
    if (examine(vertices, &polygon) != SELVAGE_OK) continue;
    const auto plane = ProjectivePlane::of_all(polygon);
    if (!plane || plane->lanes().error_fx32 > kMostSteppedError_fx32) continue;
    const int32_t height = polygon.bottom_row - polygon.top_row;
    const PlaneBend bend(plane->lanes(), height);
    for (int32_t row = polygon.top_row; row < polygon.bottom_row; row += 1 + height / 5) {
      SpanWalk walk(polygon, {-32768, row, 32768, row + 1});
      if (!walk.next() || walk.whole_span().width_px() < 2) continue;
      ++rows;
      expect_chord_bound(bend.of(walk.whole_span()), terms(plane->lanes(), height),
                         *spec::scan_line(vertices, row));
      if (HasFailure()) FAIL() << "seed " << seed << ", row " << row;
    }
  }
  EXPECT_GT(rows, 1000);
}

TEST(Bend, BetweenTwoEdgesIsThatOfTheSpecification) {
  int rows = 0;
  for (uint64_t seed = 1; seed <= 2000; ++seed) {
    spec::Random random(seed);
    const std::vector<selvage_vertex> vertices = random_vertices(random, 4);
    Polygon polygon;
    if (examine(vertices, &polygon) != SELVAGE_OK) continue;
    const int32_t row = (polygon.top_row + polygon.bottom_row) / 2;
    SpanWalk walk(polygon, {-32768, row, 32768, row + 1});
    if (!walk.next() || walk.whole_span().width_px() < 2) continue;
    ++rows;
    const Span whole = walk.whole_span();
    const ProjectiveLanes lanes(walk.map(), whole);
    expect_chord_bound(bend_of(lanes, whole.width_px()), terms(lanes.field(whole), 0),
                       *spec::scan_line(vertices, row));
    if (HasFailure()) FAIL() << "seed " << seed;
  }
  EXPECT_GT(rows, 300);
}

TEST(Bend, NoRowOfAPlaneBendsLessThanTheLeast) {
  for (uint64_t seed = 1; seed <= 600; ++seed) {
    spec::Random random(seed);
    const std::vector<selvage_vertex> vertices = random_vertices(random, 3);
    Polygon polygon;
    if (examine(vertices, &polygon) != SELVAGE_OK) continue;
    const auto plane = ProjectivePlane::of_all(polygon);
    if (!plane) continue;
    const PlaneBend bend(plane->lanes(), polygon.bottom_row - polygon.top_row);
    const RowBend least = bend.least(7);
    EXPECT_EQ(least.least_denominator, 7);
    EXPECT_EQ(least.turn, std::abs(plane->lanes().denominator.step_x));
    for (int32_t row = polygon.top_row; row < polygon.bottom_row; ++row) {
      const RowBend here = bend.of({row, polygon.left_px, polygon.right_px});
      ASSERT_LE(least.slope_fx32, here.slope_fx32) << "seed " << seed << ", row " << row;
    }
  }
}

// Where u alone bends, the least is that of the end that bends less, or nothing but its error.
TEST(Bend, TheLeastIsReached) {
  const auto field = [](double first, double last) {
    // K = n' d - n d' with n' = 1, d' = 1/4, d = 1 down all 8 rows: K = 1 - n / 4.
    const double n = 4 * (1 - first), n_last = 4 * (1 - last);
    return ProjectiveField{0, 0, {n, 1, (n_last - n) / 8}, {0, 0, 0}, {1, 0.25, 0}, 0};
  };
  const auto least = [&](double first, double last) {
    return PlaneBend(field(first, last), 8).least(1).slope_fx32;
  };
  EXPECT_NEAR(least(3, 5), 3, 0x1p-40);
  EXPECT_NEAR(least(5, 3), 3, 0x1p-40);
  EXPECT_NEAR(least(-3, -5), 3, 0x1p-40);
  EXPECT_NEAR(least(-5, -3), 3, 0x1p-40);
  EXPECT_NEAR(least(5, -3), 0, 0x1p-40);
  EXPECT_NEAR(least(-3, 5), 0, 0x1p-40);
  EXPECT_GT(least(5, -3), 0);
}

// u and v are constant: their slopes are 0, and what is told is what is added for roundings, for
// whichever has the greater terms.
TEST(Bend, WhatIsAddedIsAShareOfTheTerms) {
  const ProjectiveField::Form d{3, -0.25, 0.5};
  const auto times = [&](double by) {
    return ProjectiveField::Form{by * d.start, by * d.step_x, by * d.step_y};
  };
  for (const int32_t rows : {1, 6}) {
    const double terms = 2 * 0.25 * (3 + rows * 0.5);
    for (const auto& [u, v] : {std::pair(16.0, 1.0), std::pair(1.0, 16.0), std::pair(-16.0, 1.0)}) {
      const ProjectiveField field{5, 10, times(u), times(v), d, 0};
      const PlaneBend bend(field, rows);
      EXPECT_EQ(bend.of({11, 7, 9}).slope_fx32, 16 * terms * 0x1p-49);
      EXPECT_EQ(bend.least(1).slope_fx32, 16 * terms * 0x1p-49);
      const double row_terms = 2 * 0.25 * 3.0;
      const DividedLanes lanes({u * 3, u * -0.25}, {v * 3, v * -0.25}, {3, -0.25}, 0);
      EXPECT_EQ(bend_of(lanes, 4).slope_fx32, 16 * row_terms * 0x1p-49);
    }
  }
}

TEST(Bend, TheLeastDenominatorIsAtAnEndOfTheRow) {
  for (const double step : {-0.25, 0.25}) {
    const ProjectiveField field{5, 10, {1, 2, 3}, {4, 5, 6}, {30, step, 0.5}, 0};
    // Two rows down, two columns right of the field's first pixel, and three more.
    const RowBend row = PlaneBend(field, 8).of({12, 7, 11});
    EXPECT_EQ(row.least_denominator, 31 + (step < 0 ? 5 : 2) * step);
    EXPECT_EQ(row.turn, 0.25);
    const RowBend alone = bend_of({{1, 2}, {4, 5}, {30, step}, 0}, 4);
    EXPECT_EQ(alone.least_denominator, 30 + (step < 0 ? 3 : 0) * step);
    EXPECT_EQ(alone.turn, 0.25);
  }
}

}  // namespace
}  // namespace selvage::mapper
