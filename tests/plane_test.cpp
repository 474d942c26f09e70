#include "mapper/plane.h"

#include "mapper/exact_row.h"
#include "mapper/vector/kernel.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <utility>
#include <vector>

#include "spec/exact.h"
#include "spec/generate.h"
#include "spec/random.h"
#include "tests/kernel_support.h"
#include "tests/span_support.h"
#include "tests/whole.h"

namespace selvage::mapper {
namespace {

using spec::Rational;

[[nodiscard]] std::optional<Plane> plane_of(const std::vector<selvage_vertex>& vertices,
                                            const selvage_rect& visible = {0, 0, 4096, 4096}) {
  Polygon polygon;
  EXPECT_EQ(examine(vertices, &polygon), SELVAGE_OK);
  return Plane::of(polygon, part_of(polygon, visible));
}

// The law of the filter, and the exact decision, at one pixel.
void expect_lawful_affine(const Plane& plane, const AffineLanes& lanes, const Span& span,
                          int32_t offset_px, const spec::Case& c) {
  const int32_t px = span.left_px + offset_px;
  const auto exact = spec::sample(c.vertices, px, span.row);
  const Lane lane = lanes.at(offset_px);
  const auto holds = [&](int64_t lane_fx32, const Rational& texel) {
    const Rational true_fx32 = texel * Rational(4294967296.0);
    return spec::rational(lane_fx32) <= true_fx32 &&
           true_fx32 < spec::rational(lane_fx32 + lanes.margin_fx32());
  };
  ASSERT_TRUE(holds(lane.u_fx32, exact->u) && holds(lane.v_fx32, exact->v)) << spec::print(c);
  for (const int32_t below : {0, 1}) {
    const int32_t s = spec::floor(exact->u), t = spec::floor(exact->v);
    const ExactRow row = ExactMap(plane).row_from(span.left_px, span.row);
    ASSERT_EQ(row.reaches(row.u, offset_px, s + below), below == 0) << spec::print(c);
    ASSERT_EQ(row.reaches(row.v, offset_px, t + below), below == 0) << spec::print(c);
  }
}

TEST(Plane, LanesAreLowByLessThanTheirMargin) {
  int with_plane = 0, triangles = 0, triangles_without = 0;
  for (uint64_t seed = 1; seed <= 6000; ++seed) {
    spec::Case c = spec::generate(seed);
    for (selvage_vertex& v : c.vertices) v.q = 1;
    const selvage_rect visible{-2, 0, c.target_width_px + 2, c.target_height_px};
    Polygon polygon;
    if (examine(c.vertices, &polygon) != SELVAGE_OK) continue;
    const std::optional<Plane> plane = Plane::of(polygon, part_of(polygon, visible));
    bool covers = false;
    for_each_span(c, [&](const spec::Case&, const Polygon&, const SpanMap&, const Span& span) {
      covers = true;
      if (!plane) return;
      const AffineField& field = plane->lanes();
      const AffineLanes lanes(field.at(span.left_px, span.row), field.step_x, field.margin_fx32);
      const int32_t last = span.width_px() - 1;
      for (const int32_t offset_px : {0, last / 2, last}) {
        expect_lawful_affine(*plane, lanes, span, offset_px, c);
      }
    });
    if (!covers) continue;
    with_plane += plane ? 1 : 0;
    triangles += c.vertices.size() == 3 ? 1 : 0;
    triangles_without += c.vertices.size() == 3 && !plane ? 1 : 0;
  }
  EXPECT_GT(with_plane, 1000);
  EXPECT_LT(triangles_without, triangles / 4);  // steep slivers, of which the generator is full
}

TEST(Plane, IsThatOfAllVertices) {
  std::vector<selvage_vertex> quad = {{0, 0, 0, 0, 1},
                                      {2560, 256, 655360, 65536, 1},
                                      {2816, 2816, 720896, 720896, 1},
                                      {256, 2560, 65536, 655360, 1}};
  EXPECT_TRUE(plane_of(quad));
  for (selvage_vertex& v : quad) v.x += 700, v.y += 300, v.u += 999, v.v -= 777;
  EXPECT_TRUE(plane_of(quad));
  std::ranges::reverse(quad);
  EXPECT_TRUE(plane_of(quad));
  quad[3].v += 1;
  EXPECT_FALSE(plane_of(quad));
  quad.pop_back();
  EXPECT_TRUE(plane_of(quad));
  quad.push_back(quad.back());
  quad.push_back(quad.front());  // repeated vertices
  EXPECT_TRUE(plane_of(quad));
  quad.insert(quad.begin(), quad.front());
  EXPECT_TRUE(plane_of(quad));
}

// Two vertices at one place that disagree about the texel there.
TEST(Plane, IsThatOfARepeatedOriginToo) {
  std::vector<selvage_vertex> quad = {{0, 0, 0, 0, 1},
                                      {0, 0, 9, 0, 1},
                                      {2560, 256, 655360, 65536, 1},
                                      {256, 2560, 65536, 655360, 1}};
  EXPECT_FALSE(plane_of(quad));
  quad[1].u = 0;
  EXPECT_TRUE(plane_of(quad));
}

TEST(Plane, NeedsAnAreaAndEqualQ) {
  EXPECT_FALSE(plane_of({{0, 0, 0, 0, 1}, {256, 256, 1, 1, 1}, {512, 512, 2, 2, 1}}));
  EXPECT_FALSE(plane_of({{9, 9, 0, 0, 1}, {9, 9, 1, 1, 1}, {9, 9, 2, 2, 1}}));
  EXPECT_FALSE(plane_of({{0, 0, 0, 0, 1}, {256, 0, 1, 1, 2}, {0, 512, 2, 2, 1}}));
}

// A gradient that 64 bits would not hold is left to the edges.
TEST(Plane, RefusesWhatIsTooSteep) {
  EXPECT_FALSE(plane_of({{0, 0, INT32_MIN, 0, 1}, {1, 0, INT32_MAX, 0, 1}, {0, 1, 0, 0, 1}},
                        {0, 0, 32768, 32768}));
  EXPECT_FALSE(
      plane_of({{0, 0, 0, 0, 1}, {8000000, 1, INT32_MAX, 0, 1}, {8000000, 0, INT32_MIN, 0, 1}}));
}

// Each of the four terms by itself, or two that cancel, rising or falling.
TEST(Plane, RefusesWhatIsTooSteepInAnyTerm) {
  const selvage_rect visible{0, 0, 32768, 32768};
  for (const int32_t end : {INT32_MAX, -INT32_MAX}) {
    // From pixel (0, 0), whose centre is the origin: right, down.
    EXPECT_FALSE(plane_of({{128, 128, 0, 0, 1}, {129, 128, end, 0, 1}, {128, 129, 0, 0, 1}}));
    EXPECT_FALSE(plane_of({{128, 128, 0, 0, 1}, {129, 128, 0, 0, 1}, {128, 129, end, 0, 1}}));
    // A sliver along a diagonal, its origin far from the first pixel.
    EXPECT_FALSE(plane_of(
        {{8000000, 8000000, 0, 0, 1}, {0, 0, 0, 0, 1}, {8000000, 8000256, end, 0, 1}}, visible));
  }
}

// Where gradients are dyadic, lanes hit ties exactly and nothing needs a decision.
TEST(Plane, IsExactWhereCoordinatesAreDyadic) {
  const std::vector<selvage_vertex> quad = {{0, 0, 0, 0, 1},
                                            {4096, 0, 32 << 16, 0, 1},
                                            {4096, 4096, 32 << 16, 32 << 16, 1},
                                            {0, 4096, 0, 32 << 16, 1}};
  const std::optional<Plane> plane = plane_of(quad);
  ASSERT_TRUE(plane);
  for (int32_t row = 0; row < 16; ++row) {
    const AffineField& field = plane->lanes();
    const AffineLanes lanes(field.at(3, row), field.step_x, field.margin_fx32);
    for (int32_t i = 0; i < 13; ++i) {
      ASSERT_EQ(lanes.at(i).u_fx32, int64_t{2 * (3 + i) + 1} << kLaneFraction);
      ASSERT_EQ(lanes.at(i).v_fx32, int64_t{2 * row + 1} << kLaneFraction);
    }
  }
}

// A unit for the start and one for each step to the furthest pixel (spec/proofs/plane_lanes.g), and
// no more than two to spare.
TEST(Plane, MarginHasAUnitForTheStartAndForEachStep) {
  const std::vector<selvage_vertex> triangle = {
      {0, 0, 0, 7, 1}, {20000, 300, 70000, -5, 1}, {900, 30000, 12345, 999, 1}};
  for (const selvage_rect visible : {selvage_rect{0, 0, 4096, 4096},
                                     {10, 5, 11, 6},
                                     {3, 50, 40, 60},
                                     {-100, -100, 30, 20},
                                     {70, 100, 4096, 4096}}) {
    const auto plane = plane_of(triangle, visible);
    ASSERT_TRUE(plane);
    const int32_t left = std::max(visible.left, 0), top = std::max(visible.top, 0);
    const int32_t columns = std::min(visible.right, (20000 + 127) >> 8) - left;
    const int32_t rows = std::min(visible.bottom, (30000 + 127) >> 8) - top;
    const auto margin = static_cast<int32_t>(plane->lanes().margin_fx32);
    EXPECT_GE(margin, 1 + (columns - 1) + (rows - 1));
    EXPECT_LE(margin, 1 + columns + rows);
    EXPECT_EQ(plane->lanes().first_px, left);
    EXPECT_EQ(plane->lanes().first_row, top);
  }
}

[[nodiscard]] std::vector<FindLanes> lane_kernels() {
  std::vector<FindLanes> kernels = {find_lanes_scalar};
  for (const selvage_kernel kernel : usable_kernels()) {
    const Kernels* const vectors = vector_kernels(kernel, SELVAGE_FILTER_NEAREST);
    if (vectors != nullptr) kernels.push_back(vectors->find_lanes);
  }
  return kernels;
}

// The plane of a triangle, if it has one; its lanes start at floors and go on by floors.
[[nodiscard]] std::optional<Plane> with_floors(const std::vector<selvage_vertex>& triangle,
                                               FindLanes find_lanes) {
  Polygon polygon;
  if (examine(triangle, &polygon) != SELVAGE_OK) return std::nullopt;
  const selvage_rect everywhere{-32768, -32768, 32768, 32768};
  const auto plane = Plane::of(polygon, part_of(polygon, everywhere), find_lanes);
  if (!plane) return std::nullopt;
  const PlaneFrame frame = PlaneFrame::of(triangle);
  const selvage_vertex& origin = frame.origin();
  const AffineField& lanes = plane->lanes();
  const int64_t dx = centre_fx8(lanes.first_px) - int64_t{origin.x};
  const int64_t dy = centre_fx8(lanes.first_row) - int64_t{origin.y};
  for (const auto& [texel, lane] : {std::pair(&selvage_vertex::u, &Lane::u_fx32),
                                    std::pair(&selvage_vertex::v, &Lane::v_fx32)}) {
    const auto [a, b] = frame.gradient<int64_t>(int64_t{frame.second().*texel} - origin.*texel,
                                                int64_t{frame.third().*texel} - origin.*texel);
    const int64_t d = frame.doubled_area();
    EXPECT_EQ(lanes.step_x.*lane, floor_of(int128{a} << 24, d));
    EXPECT_EQ(lanes.step_y.*lane, floor_of(int128{b} << 24, d));
    EXPECT_EQ(lanes.start.*lane, (int64_t{origin.*texel} << 16) +
                                     floor_of((int128{a} * dx + int128{b} * dy) << 16, d));
  }
  return plane;
}

// Slivers on which estimates in double are several units off, and gradients that are whole.
TEST(Plane, StartsAndStepsAreFloorsHoweverSteep) {
  spec::Random random(12);
  const std::vector<FindLanes> kernels = lane_kernels();
  int planes = 0, steep = 0;
  for (int i = 0; i < 30000 && !HasFailure(); ++i) {
    SCOPED_TRACE(i);
    const int32_t far = 1 << random.in(1, 13), furthest = 1 << random.in(1, 31);
    const int32_t unit = random.pick({1, 1, 256});
    std::vector<selvage_vertex> triangle;
    for (int k = 0; k < 3; ++k) {
      const int32_t x = random.in(-far, far), y = random.in(-far, far);
      const bool whole = unit != 1;
      const int32_t u = whole ? x * unit : random.in(-furthest, furthest);
      triangle.push_back({x, y, u, random.in(-furthest, furthest), 1});
    }
    for (const FindLanes find_lanes : kernels) {
      const std::optional<Plane> plane = with_floors(triangle, find_lanes);
      if (!plane) break;
      ++planes;
      steep += std::abs(plane->lanes().step_x.u_fx32) > int64_t{1} << 50 ? 1 : 0;
      steep += std::abs(plane->lanes().step_x.v_fx32) > int64_t{1} << 50 ? 1 : 0;
    }
  }
  EXPECT_GT(planes, 10000 * static_cast<int>(kernels.size()));
  EXPECT_GT(steep, 100 * static_cast<int>(kernels.size()));
}

// (s, t) with a s + b t the greatest common divisor of a and b.
[[nodiscard]] std::pair<int32_t, int32_t> bezout(int32_t a, int32_t b) {
  if (b == 0) return {1, 0};
  const auto [s, t] = bezout(b, a % b);
  return {t, s - a / b * t};
}

// Long slivers of an area of a few units: their planes rise far from the first vertex to the first
// pixel, and remainders are often the least or the greatest that there can be.
TEST(Plane, StartsAndStepsAreFloorsOfTheThinnestSlivers) {
  spec::Random random(13);
  const std::vector<FindLanes> kernels = lane_kernels();
  int planes = 0;
  for (int i = 0; i < 60000 && !HasFailure(); ++i) {
    SCOPED_TRACE(i);
    const int32_t x = random.in(2048, 8192), y = random.in(2048, 8192) * random.pick({1, -1});
    const int32_t area = random.in(3, 60), more = random.in(-1, 2);
    const int32_t furthest = random.in(1 << 6, 1 << 12);
    const auto [s, t] = bezout(x, y);
    std::vector<selvage_vertex> triangle = {
        {x, y, 0, 0, 1}, {0, 0, 0, 0, 1}, {more * x - area * t, more * y + area * s, 0, 0, 1}};
    for (selvage_vertex& vertex : triangle) {
      vertex.u = random.in(-furthest, furthest);
      vertex.v = random.in(-furthest, furthest);
    }
    for (const FindLanes find_lanes : kernels) planes += with_floors(triangle, find_lanes) ? 1 : 0;
  }
  EXPECT_GT(planes, 30000 * static_cast<int>(kernels.size()));
}

// Large triangles with steep maps, which vectors of doubles cannot hold exactly, and those that
// they just can.
TEST(Plane, StartsAndStepsAreFloorsAboutTheLimitsOfDouble) {
  spec::Random random(14);
  const std::vector<FindLanes> kernels = lane_kernels();
  int planes = 0, exact = 0, inexact = 0;
  for (int i = 0; i < 60000 && !HasFailure(); ++i) {
    SCOPED_TRACE(i);
    const int32_t far = 1 << random.in(8, 23), furthest = 1 << random.in(20, 31);
    std::vector<selvage_vertex> triangle(3);
    for (selvage_vertex& v : triangle) {
      v = {random.in(-far, far), random.in(-far, far), random.in(-furthest, furthest),
           random.in(-furthest, furthest), 1};
    }
    const double product = static_cast<double>(furthest) * far;
    for (const FindLanes find_lanes : kernels) {
      const bool is_plane = with_floors(triangle, find_lanes).has_value();
      planes += is_plane ? 1 : 0;
      exact += is_plane && product * far < kMostExactProduct / 16 ? 1 : 0;
      inexact += is_plane && product > kMostExactProduct / 4 ? 1 : 0;
    }
  }
  EXPECT_GT(planes, 50000 * static_cast<int>(kernels.size()));
  EXPECT_GT(exact, 5000 * static_cast<int>(kernels.size()));
  EXPECT_GT(inexact, 1000 * static_cast<int>(kernels.size()));
}

}  // namespace
}  // namespace selvage::mapper
