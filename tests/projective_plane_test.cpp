#include "mapper/projective_plane.h"

#include "mapper/exact_row.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "spec/exact.h"
#include "spec/generate.h"
#include "spec/laws.h"
#include "spec/random.h"
#include "tests/span_support.h"

namespace selvage::mapper {
namespace {

using spec::Rational;

[[nodiscard]] std::optional<ProjectivePlane> projective_plane_of(
    const std::vector<selvage_vertex>& vertices,
    const selvage_rect& visible = {-32768, -32768, 32768, 32768}) {
  Polygon polygon;
  EXPECT_EQ(examine(vertices, &polygon), SELVAGE_OK);
  return ProjectivePlane::of(polygon, visible);
}

// The law of the filter, and the exact decision, at one pixel.
void expect_lawful_projective(const ProjectivePlane& plane, const Span& span, int32_t offset_px,
                              const std::vector<selvage_vertex>& vertices) {
  const auto exact = spec::sample(vertices, span.left_px + offset_px, span.row);
  ASSERT_TRUE(exact);
  const DividedLanes lanes = plane.lanes().of(span);
  const Lane lane = lanes.at(offset_px);
  const auto holds = [&](int64_t lane_fx32, const Rational& texel) {
    const Rational true_fx32 = texel * Rational(4294967296.0);
    return spec::rational(lane_fx32) <= true_fx32 &&
           true_fx32 < spec::rational(lane_fx32 + lanes.margin_fx32());
  };
  ASSERT_TRUE(holds(lane.u_fx32, exact->u) && holds(lane.v_fx32, exact->v));
  const ExactRow row = ExactMap(plane).row_from(span.left_px, span.row);
  for (const int32_t below : {0, 1}) {
    const int32_t s = spec::floor(exact->u), t = spec::floor(exact->v);
    ASSERT_EQ(row.reaches(row.u, offset_px, s + below), below == 0);
    ASSERT_EQ(row.reaches(row.v, offset_px, t + below), below == 0);
  }
}

void expect_lawful_projective(const ProjectivePlane& plane, const Span& span,
                              const std::vector<selvage_vertex>& vertices) {
  const int32_t last = span.width_px() - 1;
  for (const int32_t offset_px : {0, last / 2, last}) {
    expect_lawful_projective(plane, span, offset_px, vertices);
  }
}

[[nodiscard]] bool same(const ProjectiveField& a, const ProjectiveField& b) {
  const auto line = [](const ProjectiveField::Form& x, const ProjectiveField::Form& y) {
    return x.start == y.start && x.step_x == y.step_x && x.step_y == y.step_y;
  };
  return a.first_px == b.first_px && a.first_row == b.first_row && a.error_fx32 == b.error_fx32 &&
         line(a.u_fx32, b.u_fx32) && line(a.v_fx32, b.v_fx32) && line(a.denominator, b.denominator);
}

// A triangle with vertices more on edges whose ends have one q, at uneven parts of them: doubled
// areas differ by factors that are no powers of two.
[[nodiscard]] std::vector<selvage_vertex> triangle_of_five(spec::Random& random) {
  const auto any = [&](int32_t most) { return 35 * random.in(-most, most); };
  const int32_t q = random.in(1, 1 << 20);
  const selvage_vertex a{any(999), any(999), any(999), any(999), q};
  const selvage_vertex b{any(999), any(999), any(999), any(999), q};
  const bool level = random.percent(50);
  const selvage_vertex c{any(999), any(999), any(999), any(999), level ? q : q + random.in(1, 99)};
  const auto part = [](const selvage_vertex& x, const selvage_vertex& y, int32_t parts) {
    const auto at = [&](int32_t from, int32_t to) { return from + (to - from) / parts; };
    return selvage_vertex{at(x.x, y.x), at(x.y, y.y), at(x.u, y.u), at(x.v, y.v), x.q};
  };
  std::vector<selvage_vertex> vertices{a, part(a, b, 5), b, c};
  if (level) vertices.insert(vertices.begin() + 3, part(b, c, 7));
  return vertices;
}

TEST(ProjectivePlane, OfAllIsTheSameInWhateverOrder) {
  int planes = 0;
  for (uint64_t seed = 1; seed <= 400; ++seed) {
    spec::Random random(seed);
    std::vector<selvage_vertex> vertices = triangle_of_five(random);
    const auto lanes = [&]() -> std::optional<ProjectiveField> {
      Polygon polygon;
      EXPECT_EQ(examine(vertices, &polygon), SELVAGE_OK);
      const auto plane = ProjectivePlane::of_all(polygon);
      return plane ? std::optional(plane->lanes()) : std::nullopt;
    };
    const auto first = lanes();
    planes += first.has_value();
    for (size_t turn = 0; turn < vertices.size(); ++turn) {
      std::ranges::rotate(vertices, vertices.begin() + 1);
      for (int winding = 0; winding < 2; ++winding) {
        std::ranges::reverse(vertices);
        const auto again = lanes();
        ASSERT_EQ(again.has_value(), first.has_value()) << seed;
        ASSERT_TRUE(!first || same(*again, *first)) << seed;
      }
    }
  }
  EXPECT_GT(planes, 300);
}

TEST(ProjectivePlane, OfAllIsNoneWhereAllVerticesAreOnOneLine) {
  const std::vector<selvage_vertex> vertices = {
      {0, 0, 0, 0, 1}, {512, 256, 65536, 0, 2}, {1024, 512, 0, 65536, 3}, {512, 256, 65536, 0, 2}};
  Polygon polygon;
  ASSERT_EQ(examine(vertices, &polygon), SELVAGE_OK);
  EXPECT_FALSE(ProjectivePlane::of_all(polygon));
}

TEST(ProjectivePlane, LanesAreLowByLessThanTheirMargin) {
  int with_plane = 0, triangles = 0, triangles_without = 0;
  for (uint64_t seed = 1; seed <= 6000; ++seed) {
    const spec::Case c = spec::generate(seed);
    Polygon polygon;
    if (examine(c.vertices, &polygon) != SELVAGE_OK) continue;
    const selvage_rect visible{-2, 0, c.target_width_px + 2, c.target_height_px};
    const std::optional<ProjectivePlane> plane = ProjectivePlane::of(polygon, visible);
    bool covers = false;
    for_each_span(c, [&](const spec::Case&, const Polygon&, const SpanMap&, const Span& span) {
      covers = true;
      SCOPED_TRACE(seed);
      if (plane) expect_lawful_projective(*plane, span, c.vertices);
    });
    if (HasFatalFailure()) return;
    if (!covers || polygon.affine) continue;
    with_plane += plane ? 1 : 0;
    triangles += c.vertices.size() == 3 ? 1 : 0;
    triangles_without += c.vertices.size() == 3 && !plane ? 1 : 0;
  }
  EXPECT_GT(with_plane, 400);
  EXPECT_LT(triangles_without, triangles / 4);  // steep slivers, of which the generator is full
}

// Triangles with all of the range, drawn at random rows: numerators are as long as they get.
TEST(ProjectivePlane, HoldsOverTheWholeRange) {
  spec::Random random(1);
  int with_plane = 0;
  for (int i = 0; i < 1000; ++i) {
    std::vector<selvage_vertex> triangle(3);
    for (selvage_vertex& v : triangle) {
      v.x = random.in(SELVAGE_X_MIN, SELVAGE_X_END);
      v.y = random.in(SELVAGE_X_MIN, SELVAGE_X_END);
      v.u = random.percent(50) ? INT32_MAX : INT32_MIN;
      v.v = random.in(INT32_MIN, INT32_MAX);
      v.q = random.percent(50) ? random.in(1, int64_t{SELVAGE_Q_MAX} + 1) : random.in(1, 9);
    }
    Polygon polygon;
    ASSERT_EQ(examine(triangle, &polygon), SELVAGE_OK);
    const auto plane = ProjectivePlane::of(polygon, {-32768, -32768, 32768, 32768});
    if (!plane) continue;
    ++with_plane;
    SCOPED_TRACE(i);
    for (int32_t k = 0; k < 4; ++k) {
      const int32_t row = random.in(polygon.top_row, polygon.bottom_row);
      for_each_row(polygon, row, row + 1, -32768, 32768,
                   [&](const Edge&, const Edge&, const Span& span) {
                     expect_lawful_projective(*plane, span, triangle);
                   });
    }
    if (HasFatalFailure()) return;
  }
  EXPECT_GT(with_plane, 150);  // not with q from 1 to 2^24
}

// Corners of the unit square under one projective map: its sums of w, w x and w y over opposite
// corners agree.
[[nodiscard]] std::vector<selvage_vertex> tilted_quad() {
  constexpr int32_t texel = SELVAGE_SUBTEXELS;
  return {{190 * 256, 150 * 256, 0, 0, 10},
          {880 * 256, 95 * 256, 64 * texel, 0, 15},
          {960 * 256, 960 * 256, 64 * texel, 64 * texel, 20},
          {100 * 256, 680 * 256, 0, 64 * texel, 12}};
}

TEST(ProjectivePlane, IsThatOfAllVertices) {
  std::vector<selvage_vertex> quad = tilted_quad();
  EXPECT_TRUE(projective_plane_of(quad));
  for (int32_t selvage_vertex::*member :
       {&selvage_vertex::x, &selvage_vertex::u, &selvage_vertex::v, &selvage_vertex::q}) {
    quad[3].*member += 1;
    EXPECT_FALSE(projective_plane_of(quad));
    quad[3].*member -= 1;
  }
  quad.push_back(quad.back());
  quad.push_back(quad.front());  // repeated vertices
  EXPECT_TRUE(projective_plane_of(quad));
  quad.insert(quad.begin(), quad.front());
  EXPECT_TRUE(projective_plane_of(quad));
}

TEST(ProjectivePlane, NeedsAnArea) {
  EXPECT_FALSE(projective_plane_of({{0, 0, 0, 0, 1}, {256, 256, 1, 1, 2}, {512, 512, 2, 2, 3}}));
  EXPECT_FALSE(projective_plane_of({{9, 9, 0, 0, 1}, {9, 9, 1, 1, 2}, {9, 9, 2, 2, 3}}));
}

// A sliver along the pixels' diagonal, whose q is 1 there and grows across it, so that the plane's
// denominators go up to 512 n (q - 1) + 1 in its n by n pixels.
[[nodiscard]] std::vector<selvage_vertex> sliver(int32_t q) {
  constexpr int32_t kFar_fx8 = 1 << 22, kFar_fx16 = 1 << 27;
  return {{0, 0, 0, 0, 1},
          {kFar_fx8 + 1, kFar_fx8, kFar_fx16, kFar_fx16, q},
          {kFar_fx8, kFar_fx8, kFar_fx16, -kFar_fx16, 1}};
}

TEST(ProjectivePlane, RefusesWhatReachesTooFar) {
  const std::optional<ProjectivePlane> far = projective_plane_of(sliver(2), {0, 0, 100, 100});
  ASSERT_TRUE(far);
  EXPECT_GT(far->lanes().error_fx32, kMostReach / 2);
  EXPECT_LE(far->lanes().error_fx32, int64_t{kMostReach} + kProjectiveTruncations_fx32);
  EXPECT_FALSE(projective_plane_of(sliver(3), {0, 0, 100, 100}));
  EXPECT_FALSE(projective_plane_of(sliver(SELVAGE_Q_MAX)));
  EXPECT_TRUE(projective_plane_of(sliver(3), {0, 0, 50, 50}))
      << "the part that is seen reaches less far";
}

// Exact on both sides of that limit, whichever kernel draws.
TEST(ProjectivePlane, DrawsSliversAsTheModelDoes) {
  spec::Case c;
  c.target_width_px = c.target_height_px = 50;
  c.texture_width_texel = c.texture_height_texel = 64;
  for (const int32_t q : {2, 3, 32, 1000, int32_t{SELVAGE_Q_MAX}}) {
    c.vertices = sliver(q);
    const selvage_rect all{0, 0, c.target_width_px, c.target_height_px};
    EXPECT_EQ(projective_plane_of(c.vertices, all).has_value(), q <= 3) << q;
    for (const char* law : {"COV", "MAP", "SAME"}) {
      const spec::Judgement judgement = spec::find_law(law)->check(spec::built_in(), c);
      EXPECT_FALSE(judgement.violation) << spec::explain(*judgement.violation);
      EXPECT_GT(judgement.judged_px, 0U);
    }
  }
}

TEST(ProjectivePlane, StepsAreDifferences) {
  const std::optional<ProjectivePlane> plane = projective_plane_of(tilted_quad());
  ASSERT_TRUE(plane);
  const ExactRow row = ExactMap(*plane).row_from(300, 400),
                 next = ExactMap(*plane).row_from(301, 400);
  for (const auto line : {&ExactRow::u, &ExactRow::v, &ExactRow::d}) {
    EXPECT_TRUE((next.*line).start - (row.*line).start == (row.*line).step);
    EXPECT_TRUE((next.*line).start == (row.*line).at(1));
  }
}

[[nodiscard]] double magnitude_of(int128 n) { return std::abs(static_cast<double>(n)); }

// The reach of the proof (spec/proofs/projective_plane.g), from the exact numerators, over the
// visible part of the polygon.
struct Reach {
  double reach, turn, steepest_fx32;
};
[[nodiscard]] Reach reach_of(const ProjectivePlane& plane, const std::vector<selvage_vertex>& of,
                             const selvage_rect& part) {
  double least_q = double{SELVAGE_Q_MAX}, furthest_texel = 0;
  for (const selvage_vertex& v : of) {
    least_q = std::min<double>(least_q, v.q);
    furthest_texel = std::max({furthest_texel, std::abs(v.u / 65536.0), std::abs(v.v / 65536.0)});
  }
  const double least =
      least_q * static_cast<double>(PlaneFrame::of(of).doubled_area()) * double{SELVAGE_SUBTEXELS};
  const auto most = [&](const auto& at, int128 step) {
    const int128 start = at(part.left, part.top), down = at(part.left, part.top + 1) - start;
    return (magnitude_of(start) + (part.right - part.left) * magnitude_of(step) +
            (part.bottom - part.top) * magnitude_of(down)) /
           least;
  };
  const auto u = [&](int32_t px, int32_t row) { return plane.u_numerator(px, row); };
  const auto v = [&](int32_t px, int32_t row) { return plane.v_numerator(px, row); };
  const auto d = [&](int32_t px, int32_t row) { return plane.denominator(px, row); };
  const double texels =
      std::max(most(u, plane.u_numerator_step()), most(v, plane.v_numerator_step()));
  const double turn = magnitude_of(plane.denominator_step()) / least;
  const double step =
      std::max(magnitude_of(plane.u_numerator_step()), magnitude_of(plane.v_numerator_step())) /
      least;
  return {texels / 32768 + most(d, plane.denominator_step()), turn,
          (step + furthest_texel * turn) * 4294967296.0};
}

TEST(ProjectivePlane, BoundsWhatTheProofBounds) {
  spec::Random random(9);
  int planes = 0;
  for (int i = 0; i < 4000; ++i) {
    std::vector<selvage_vertex> triangle;
    const int32_t far = 1 << random.in(10, 18), furthest = 1 << random.in(4, 31);
    for (int k = 0; k < 3; ++k) {
      triangle.push_back({random.in(-far, far), random.in(-far, far),
                          random.in(-furthest, furthest), random.in(-furthest, furthest),
                          random.in(1, 1 << random.in(1, 24))});
    }
    Polygon polygon;
    if (examine(triangle, &polygon) != SELVAGE_OK) continue;
    const int32_t left = random.in(-300, 300), top = random.in(-300, 300);
    const selvage_rect visible{left, top, left + random.in(1, 600), top + random.in(1, 600)};
    const selvage_rect part{std::max(left, polygon.left_px), std::max(top, polygon.top_row),
                            std::min(visible.right, polygon.right_px),
                            std::min(visible.bottom, polygon.bottom_row)};
    if (part.left >= part.right || part.top >= part.bottom) continue;
    const auto plane = ProjectivePlane::of(polygon, visible);
    if (!plane) continue;
    ++planes;
    const ProjectiveField& lanes = plane->lanes();
    const Reach wanted = reach_of(*plane, triangle, part);
    constexpr double kRounded = 1e-9;
    const auto error = static_cast<double>(lanes.error_fx32 - kProjectiveTruncations_fx32);
    ASSERT_GE(error, std::floor(wanted.reach * (1 - kRounded))) << i;
    ASSERT_LE(error, std::floor(wanted.reach * (1 + kRounded))) << i;
    ASSERT_LE(wanted.reach, kMostReach * (1 + kRounded)) << i;
    ASSERT_NEAR(lanes.turn, wanted.turn, kRounded * wanted.turn) << i;
    ASSERT_NEAR(lanes.steepest_fx32, wanted.steepest_fx32, kRounded * wanted.steepest_fx32) << i;
    ASSERT_EQ(lanes.first_px, part.left);
    ASSERT_EQ(lanes.first_row, part.top);
  }
  EXPECT_GT(planes, 400);
}

// The second vertex is where the first one is, with a texture vertex of its own.
TEST(ProjectivePlane, IsNotOfARepeatedVertexWithOtherCoordinates) {
  std::vector<selvage_vertex> vertices = {
      {0, 0, 0, 0, 1}, {0, 0, 0, 0, 1}, {9000, 100, 60000, 5, 2}, {300, 8000, 7, 90000, 3}};
  EXPECT_TRUE(projective_plane_of(vertices));
  vertices[1].u = 1;
  EXPECT_FALSE(projective_plane_of(vertices));
  vertices[1] = vertices[0];
  vertices[1].q = 2;
  EXPECT_FALSE(projective_plane_of(vertices));
}

}  // namespace
}  // namespace selvage::mapper
