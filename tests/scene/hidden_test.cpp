// Hidden surfaces: what shows is what an exact depth test at every pixel shows.
#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>
#include <set>

#include "bodies.h"
#include "index_picture.h"
#include "plane_face.h"
#include "scene/fraction.h"
#include "scene/look.h"
#include "spec/geometry.h"
#include "spec/visibility.h"

namespace selvage::scene {
namespace {

inline constexpr Size kDepthTestTarget{40, 28};

// Coordinates that meet centres, vertices and each other often, or hardly ever.
// Now and then as far away as the guard band lets them be.
[[nodiscard]] selvage_vertex random_vertex(spec::Random& random, int32_t grid_fx8, int32_t least_q,
                                           int32_t most_q) {
  const auto place = [&](int32_t size_px) {
    if (grid_fx8 == 1 && random.percent(10)) {
      const auto guard_fx8 = static_cast<int32_t>(kGuard_px) * SELVAGE_SUBPIXELS;
      return random.in(-guard_fx8, guard_fx8 + 1);
    }
    const int32_t steps = (size_px + 16) * SELVAGE_SUBPIXELS / grid_fx8;
    return random.in(0, steps) * grid_fx8 - 8 * SELVAGE_SUBPIXELS;
  };
  const int32_t x = place(kDepthTestTarget.width_px), y = place(kDepthTestTarget.height_px);
  return {x, y, 0, 0, random.in(least_q, int64_t{most_q} + 1)};
}

// Triangles and hulls with a q at each corner by itself: they cut through each other, share
// corners, and lie in one plane now and then.
[[nodiscard]] std::vector<ScreenFace> random_faces(uint64_t seed) {
  spec::Random random(seed);
  const int32_t grid_fx8 = random.pick({1, 1, 128, 256, 1024});
  const int32_t least_q = random.pick({1, 1, 1000, 1 << 23});
  const int32_t most_q = random.pick({least_q, least_q + 3, least_q * 2, 1 << 24});
  std::vector<ScreenFace> faces;
  const int count = random.in(1, 12);
  while (static_cast<int>(faces.size()) < count) {
    std::vector<selvage_vertex> vertices;
    const int corners = random.percent(60) ? 3 : random.in(4, 9);
    for (int i = 0; i < corners; ++i) {
      vertices.push_back(random_vertex(random, grid_fx8, least_q, most_q));
      if (!faces.empty() && random.percent(20)) {
        const auto& others = faces[random.below(faces.size())].vertices;
        vertices.back() = others[random.below(others.size())];
      }
    }
    if (corners > 3) vertices = spec::convex_hull(vertices);
    if (vertices.size() < 3) continue;
    faces.push_back({0, faces.size(), vertices, 0, {}});
  }
  return faces;
}

[[nodiscard]] spec::Polygons outlines(std::span<const ScreenFace> faces) {
  spec::Polygons polygons;
  for (const ScreenFace& face : faces) polygons.push_back(face.vertices);
  return polygons;
}

[[nodiscard]] std::vector<int> by_depth_test(std::span<const ScreenFace> faces, Size size) {
  std::vector<int> shown;
  for (const auto& face : spec::visible(outlines(faces), size.width_px, size.height_px)) {
    shown.push_back(face ? static_cast<int>(*face) : -1);
  }
  return shown;
}

TEST(ScanLine, ShowsWhatAnExactDepthTestShowsAndWritesItOnce) {
  int64_t overlapped = 0, pieces_drawn = 0;
  for (uint64_t seed = 1; seed <= 600; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const std::vector<ScreenFace> faces = random_faces(seed);
    const std::vector<Piece> pieces = visible_pieces(Hidden::kScanLine, faces, kDepthTestTarget);
    const IndexPicture drawn = draw_indices(pieces, faces, kDepthTestTarget);
    const std::vector<int> expected = by_depth_test(faces, kDepthTestTarget);
    ASSERT_EQ(drawn.face, expected);
    for (size_t i = 0; i < expected.size(); ++i) {
      ASSERT_EQ(drawn.writes[i], expected[i] < 0 ? 0 : 1) << "pixel " << i;
    }
    const auto painted = draw_indices(visible_pieces(Hidden::kPainter, faces, kDepthTestTarget),
                                      faces, kDepthTestTarget);
    overlapped += std::count_if(painted.writes.begin(), painted.writes.end(),
                                [](int writes) { return writes > 1; });
    pieces_drawn += static_cast<int64_t>(pieces.size());
  }
  std::cout << overlapped << " pixels of several faces, " << pieces_drawn << " pieces\n";
  EXPECT_GT(overlapped, 100000);
}

// Two faces that cut through each other: each shows on one side of the cut.
TEST(ScanLine, SplitsWhereFacesInterpenetrate) {
  const int32_t w = kDepthTestTarget.width_px * 256, h = kDepthTestTarget.height_px * 256;
  std::vector<ScreenFace> faces(2);
  faces[0].vertices = {
      {0, 0, 0, 0, 1000}, {w, 0, 0, 0, 3000}, {w, h, 0, 0, 3000}, {0, h, 0, 0, 1000}};
  faces[1].vertices = {
      {0, 0, 0, 0, 2500}, {w, 0, 0, 0, 1500}, {w, h, 0, 0, 1500}, {0, h, 0, 0, 2500}};
  const auto pieces = visible_pieces(Hidden::kScanLine, faces, kDepthTestTarget);
  EXPECT_EQ(pieces.size(), 2U);  // one rectangle each, whatever the rows
  const IndexPicture drawn = draw_indices(pieces, faces, kDepthTestTarget);
  EXPECT_EQ(drawn.face[0], 1);
  EXPECT_EQ(drawn.face[static_cast<size_t>(kDepthTestTarget.width_px) - 1], 0);
  EXPECT_EQ(drawn.face, by_depth_test(faces, kDepthTestTarget));
}

TEST(ScanLine, ShowsTheFirstOfEquals) {
  std::vector<ScreenFace> faces(2);
  for (ScreenFace& face : faces) {
    face.vertices = {{0, 0, 0, 0, 7}, {5000, 300, 0, 0, 9}, {700, 5000, 0, 0, 8}};
  }
  for (const Hidden way : {Hidden::kScanLine, Hidden::kPainter}) {
    const IndexPicture drawn =
        draw_indices(visible_pieces(way, faces, kDepthTestTarget), faces, kDepthTestTarget);
    EXPECT_EQ(std::count(drawn.face.begin(), drawn.face.end(), 1), 0);
    EXPECT_GT(std::count(drawn.face.begin(), drawn.face.end(), 0), 100);
  }
}

TEST(ScanLine, DrawsAFaceThatNothingHidesInOnePiece) {
  std::vector<ScreenFace> faces(1);
  faces[0].vertices = {{-500, 300, 0, 0, 7}, {5000, -300, 0, 0, 9}, {700, 9000, 0, 0, 8}};
  EXPECT_EQ(visible_pieces(Hidden::kScanLine, faces, kDepthTestTarget).size(), 1U);
}

// Of a convex body both ways show the same: the faces that are towards the eye do not overlap.
TEST(Hidden, WaysAgreeOnConvexBodies) {
  int64_t pixels = 0;
  const Size size{64, 64};
  for (uint64_t seed = 1; seed <= 600; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    spec::Random random(seed);
    Scene scene;
    scene.objects.push_back(random.percent(20) ? cube() : ball(random.in(3, 14), random.in(2, 9)));
    Motion& motion = scene.objects[0].motion;
    motion.axis = direction(random);
    motion.angle_deg = real(random, 0, 360);
    motion.position = {real(random, -1, 1), real(random, -1, 1), real(random, -2, 2)};
    const View view = look(scene, 0, size);
    const auto painted =
        draw_indices(visible_pieces(Hidden::kPainter, view.faces, size), view.faces, size);
    const auto scanned =
        draw_indices(visible_pieces(Hidden::kScanLine, view.faces, size), view.faces, size);
    ASSERT_EQ(painted.face, scanned.face);
    ASSERT_EQ(painted.writes, scanned.writes);
    pixels += std::count(scanned.writes.begin(), scanned.writes.end(), 1);
  }
  std::cout << pixels << " pixels\n";
  EXPECT_GT(pixels, 200000);
}

// Faces of one depth each: their order is all that there is to know, of equal ones the first shows.
TEST(Hidden, PainterShowsTheNearestOfParallelFaces) {
  int64_t overlapped = 0;
  for (uint64_t seed = 1; seed <= 200; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    spec::Random random(seed);
    std::vector<ScreenFace> faces = random_faces(seed);
    for (ScreenFace& face : faces) {
      const int32_t q = random.in(1, 6);
      for (selvage_vertex& vertex : face.vertices) vertex.q = q;
      face.mean_w = 1.0 / q;
    }
    const auto painted = draw_indices(visible_pieces(Hidden::kPainter, faces, kDepthTestTarget),
                                      faces, kDepthTestTarget);
    ASSERT_EQ(painted.face, by_depth_test(faces, kDepthTestTarget));
    overlapped += std::count_if(painted.writes.begin(), painted.writes.end(),
                                [](int writes) { return writes > 1; });
  }
  EXPECT_GT(overlapped, 20000);
}

// A ball around another, both seen from outside: painter's order draws both, the scan lines one.
TEST(ScanLine, DrawsNothingOfWhatIsBehind) {
  Scene scene;
  scene.objects = {ball(12, 8), ball(9, 6)};
  scene.objects[0].motion.scale = 0.5;  // inside of the other
  const View view = look(scene, 0, kDepthTestTarget);
  const std::vector<Piece> pieces = visible_pieces(Hidden::kScanLine, view.faces, kDepthTestTarget);
  EXPECT_GT(pieces.size(), 10U);
  for (const Piece& piece : pieces) EXPECT_EQ(view.faces[piece.face].object, 1U);
  EXPECT_TRUE(std::any_of(view.faces.begin(), view.faces.end(),
                          [](const ScreenFace& face) { return face.object == 0; }));
}

TEST(Fraction, ComparesAsItsQuotients) {
  for (uint64_t seed = 1; seed <= 2000; ++seed) {
    spec::Random random(seed);
    const auto number = [&] {
      const int bits = random.in(1, 97);
      const Unsigned128 value = Unsigned128{random.bits()} << 64 | random.bits();
      return value >> (128 - bits);
    };
    const auto big = [](Unsigned128 value) {
      mpz_class high(static_cast<uint64_t>(value >> 64)), low(static_cast<uint64_t>(value));
      return mpz_class(high * (mpz_class(1) << 64) + low);
    };
    const Fraction a{number(), number() + 1};
    Fraction b{number(), number() + 1};
    const uint64_t k = random.bits() >> 60;
    if (random.percent(50)) b = {a.numerator * k + (random.bits() & 1), a.denominator * k + 1};
    if (random.percent(20)) b = {a.numerator * (k + 1), a.denominator * (k + 1)};
    const mpz_class left = big(a.numerator) * big(b.denominator);
    const mpz_class right = big(b.numerator) * big(a.denominator);
    const int order = cmp(left, right);
    EXPECT_EQ(compare(a, b) > 0, order > 0) << "seed " << seed;
    EXPECT_EQ(compare(a, b) == 0, order == 0) << "seed " << seed;
  }
}

}  // namespace
}  // namespace selvage::scene
