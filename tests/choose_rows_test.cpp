// What the rows of a polygon are drawn by within a tolerance, together and each alone.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "mapper/bend.h"
#include "mapper/polygon.h"
#include "mapper/projective_plane.h"
#include "mapper/span_walk.h"
#include "mapper/tolerance.h"
#include "mapper/tolerant_draw.h"
#include "spec/exact.h"
#include "spec/random.h"
#include "spec/tolerance.h"
#include "tests/any_tolerance.h"
#include "tests/lane_units.h"

namespace selvage::mapper {
namespace {

// A quad that bends less from row to row: the shortest segments come first or last.
TEST(ChooseRows, OfSomeRowsTheShortestSegmentsAreTold) {
  constexpr int32_t kNear = 1 << 20, kFar = kNear + (1 << 19), kTexels = 200 * SELVAGE_SUBTEXELS;
  std::vector<selvage_vertex> vertices = {
      {0, 0, 0, 0, kNear},
      {2000 * 256, 0, kTexels, 0, kFar},
      {2000 * 256, 8 * 256, kTexels, kTexels, kNear + (kFar - kNear) / 2},
      {0, 8 * 256, 0, kTexels, kNear}};
  constexpr int32_t kTolerance_fx16 = 5000;
  for (int turned = 0; turned < 2; ++turned) {
    Polygon polygon;
    ASSERT_EQ(examine(vertices, &polygon), SELVAGE_OK);
    int32_t shortest = INT32_MAX, longest = 0;
    for (int32_t row = 0; row < 8; ++row) {
      const selvage_rect alone{0, row, 2000, row + 1};
      const RowChoice choice = choose_tolerantly(alone, polygon, kTolerance_fx16);
      if (choice.segment_px == 0) continue;
      shortest = std::min(shortest, choice.segment_px);
      longest = std::max(longest, choice.segment_px);
    }
    EXPECT_LT(shortest, longest);
    const RowChoice all = choose_tolerantly({0, 0, 2000, 8}, polygon, kTolerance_fx16);
    EXPECT_EQ(all.segment_px, shortest);
    for (selvage_vertex& v : vertices) v.y = 8 * 256 - v.y;
  }
}

// A plane that reaches far would cost a unit more than what the specification allows: rows are then
// chosen by their edges. q is the same along each row.
TEST(ChooseRows, PlanesThatReachFarCostNothing) {
  constexpr int32_t kTexels = 100 * SELVAGE_SUBTEXELS, kRight_fx8 = 400 * 256,
                    kBottom_fx8 = 3 * 256;
  for (const int32_t q : {1000, 4000, 5000, 20000, 31000, 40000}) {
    const std::vector<selvage_vertex> vertices = {
        {0, 0, 0, 0, 1}, {kRight_fx8, 0, kTexels, 0, 1}, {0, kBottom_fx8, 0, kTexels, q}};
    Polygon polygon;
    ASSERT_EQ(examine(vertices, &polygon), SELVAGE_OK);
    for (const int32_t row : {0, 1}) {
      const RowChoice choice =
          choose_tolerantly({0, row, 400, row + 1}, polygon, kAnyTolerance_fx16);
      ASSERT_EQ(choice.method, SELVAGE_METHOD_AFFINE_FOR_PERSPECTIVE);
      const auto line = spec::scan_line(vertices, row);
      const double chord = spec::chord_bound(*line, 0).get_d() * kFx32PerFx16;
      const double roundings = spec::rounding_bound_fx16(*line).get_d();
      EXPECT_LE(choice.bound_fx16, std::ceil(chord + roundings)) << q;
    }
  }
}

// What a plane leaves out before its rows are looked at is left out anyway.
TEST(ChooseRows, PlanesLeaveOutNoRowThatIsStepped) {
  int stepped = 0, exact = 0;
  for (uint64_t seed = 1; seed <= 2000; ++seed) {
    spec::Random random(seed);
    const int32_t top_px = random.in(-100, 100);
    const auto vertex = [&](int32_t x_px, int32_t y_px) {
      const auto texel_fx16 = [&] { return random.in(-(1 << 22), 1 << 22); };
      return selvage_vertex{x_px * 256 + random.in(0, 9000),
                            (top_px + y_px) * 256 + random.in(0, 3000), texel_fx16(), texel_fx16(),
                            random.in(1 << 15, 1 << 16)};
    };
    std::vector<selvage_vertex> vertices = {vertex(-40, 0), vertex(300, 3), vertex(100, 20)};
    if (seed % 2 == 0) vertices[2].q = vertices[0].q;
    Polygon polygon;
    ASSERT_EQ(examine(vertices, &polygon), SELVAGE_OK);
    const auto plane = ProjectivePlane::of_all(polygon);
    ASSERT_TRUE(plane);
    const PlaneBend bend(plane->lanes(), polygon.bottom_row - polygon.top_row);
    const int32_t tolerance_fx16 = 1 << random.in(6, 24);
    SpanWalk walk(polygon,
                  {polygon.left_px, polygon.top_row, polygon.right_px, polygon.bottom_row});
    while (walk.next()) {
      const Span row = walk.whole_span();
      const RowChoice wanted =
          choose_row(bend.of(row), 2 * plane->lanes().error_fx32, row.width_px(), tolerance_fx16);
      const selvage_rect alone{row.left_px, row.row, row.right_px, row.row + 1};
      const RowChoice choice = choose_tolerantly(alone, polygon, tolerance_fx16);
      ASSERT_EQ(choice.method, wanted.method) << "seed " << seed << ", row " << row.row;
      ASSERT_EQ(choice.segment_px, wanted.segment_px);
      ASSERT_EQ(choice.bound_fx16, wanted.bound_fx16);
      (wanted.method == SELVAGE_METHOD_EXACT_PERSPECTIVE ? exact : stepped) += 1;
    }
  }
  EXPECT_GT(stepped, 1000);
  EXPECT_GT(exact, 1000);
}

// Where all rows bend alike and q hardly changes, a plane leaves out all that is not stepped, but
// none that is: with segments of 64 px.
TEST(ChooseRows, PlanesLeaveOutNoRowThatIsJustStepped) {
  constexpr int32_t kQ = 1 << 20, kRight_fx8 = 700 * 256, kBottom_fx8 = 300 * 256;
  for (const int32_t texels : {500, 4000, 30000}) {
    const std::vector<selvage_vertex> vertices = {
        {0, 0, 0, 0, kQ},
        {kRight_fx8, 0, texels * SELVAGE_SUBTEXELS, 0, kQ + 3000},
        {0, kBottom_fx8, 0, 0, kQ}};
    Polygon polygon;
    ASSERT_EQ(examine(vertices, &polygon), SELVAGE_OK);
    const selvage_rect first_row{0, 0, 700, 1};
    int32_t exact_fx16 = 0, stepped_fx16 = kAnyTolerance_fx16;
    while (stepped_fx16 - exact_fx16 > 1) {
      const int32_t middle = exact_fx16 + (stepped_fx16 - exact_fx16) / 2;
      const RowChoice choice = choose_tolerantly(first_row, polygon, middle);
      const bool stepped = choice.method != SELVAGE_METHOD_EXACT_PERSPECTIVE;
      (stepped ? stepped_fx16 : exact_fx16) = middle;
    }
    const RowChoice choice = choose_tolerantly(first_row, polygon, stepped_fx16);
    EXPECT_EQ(choice.segment_px, 64);
    EXPECT_EQ(choice.bound_fx16, stepped_fx16);
  }
}

// The whole margin of a plane's lanes: in so wide a row half of it would be a unit less.
TEST(ChooseRows, TellThePlanesMarginToo) {
  constexpr int32_t kRight_fx8 = 29500 * 256, kBottom_fx8 = 300 * 256;
  const std::vector<selvage_vertex> vertices = {
      {0, 0, 0, 0, 1}, {kRight_fx8, 0, 1 << 16, 0, 1}, {0, kBottom_fx8, 0, 1 << 16, 3900}};
  Polygon polygon;
  ASSERT_EQ(examine(vertices, &polygon), SELVAGE_OK);
  const auto plane = ProjectivePlane::of_all(polygon);
  ASSERT_TRUE(plane && plane->lanes().error_fx32 <= kMostSteppedError_fx32);
  SpanWalk walk(polygon, {0, 0, 29500, 1});
  ASSERT_TRUE(walk.next());
  const int32_t width_px = walk.whole_span().width_px();
  const int64_t margin_fx32 = plane->lanes().of(walk.whole_span()).margin_fx32();
  const int32_t roundings = roundings_fx16(margin_fx32, width_px);
  ASSERT_GT(roundings, roundings_fx16(margin_fx32 / 2, width_px));
  const RowChoice choice = choose_tolerantly({0, 0, 29500, 1}, polygon, kAnyTolerance_fx16);
  EXPECT_EQ(choice.method, SELVAGE_METHOD_AFFINE_FOR_PERSPECTIVE);
  EXPECT_EQ(choice.bound_fx16, roundings);  // q is the same along the row
}

}  // namespace
}  // namespace selvage::mapper
