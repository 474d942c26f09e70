// Coordinates next to whole numbers at every pixel: all kernels decide them alike, and margins stay
// small where depth does not.
#include <gtest/gtest.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "mapper/gentle_pieces.h"
#include "mapper/kernel.h"
#include "mapper/kernel_choice.h"
#include "spec/random.h"
#include "tests/near_ties_support.h"
#include "tests/span_support.h"

namespace selvage::mapper {
namespace {

inline constexpr int32_t kTargetWidth_px = 300;
inline constexpr int32_t kFar_px = 32766;

// u = x / `slow` + off where nothing is nudged, v as u or across.
[[nodiscard]] std::vector<selvage_vertex> far_quad(spec::Random& random) {
  // Denominators of all sizes: areas from small to the largest, any q.
  const int32_t far_px = random.percent(50) ? kFar_px : kTargetWidth_px << random.in(0, 7);
  const int32_t far_fx8 = far_px * kSubpixels, far_fx16 = far_px << kTexelFraction;
  const int32_t off_fx16 = random.pick({0, 1 << 15, 3 << 14, (1 << 15) + (1 << 8)});
  const int32_t slow = random.pick({1, 1, 2, 3, 6});
  const int32_t top_q = random.pick({1, 1 << 23, 1 << 24, 1 << random.in(0, 25)});
  const int32_t bottom_q = random.pick({top_q, top_q, 1 << 24});
  const bool across = random.percent(50);
  const auto nudge = [&] { return random.percent(40) ? random.in(-2, 3) : 0; };
  std::vector<selvage_vertex> quad;
  for (const auto& [right, below] : {std::pair(0, 0), {1, 0}, {1, 1}, {0, 1}}) {
    const int32_t u_fx16 = off_fx16 + right * (far_fx16 / slow) + nudge();
    const int32_t v_fx16 = off_fx16 + (across ? below : right) * (far_fx16 / slow) + nudge();
    const int32_t q = (below != 0 ? bottom_q : top_q) + (random.percent(10) ? 1 : 0);
    quad.push_back({right * far_fx8, below * far_fx8 - (right & below & random.in(0, 2)), u_fx16,
                    v_fx16, std::min<int32_t>(q, SELVAGE_Q_MAX)});
  }
  return quad;
}

// Cut to the width of short rows, it is the same map only where that is affine.
void narrow(std::vector<selvage_vertex>* quad, int32_t width_px) {
  const auto beyond = [&](int32_t texel_fx16) {
    const int64_t moved_fx16 = int64_t{texel_fx16} + (width_px << kTexelFraction);
    return static_cast<int32_t>(std::min<int64_t>(moved_fx16, INT32_MAX));
  };
  for (const size_t right : {size_t{1}, size_t{2}}) {
    selvage_vertex& vertex = (*quad)[right];
    const selvage_vertex& left = (*quad)[right == 1 ? 0 : 3];
    vertex.x = width_px * kSubpixels;
    vertex.u = beyond(left.u);
    vertex.v = beyond(left.v);
  }
}

// A block of seeds.
class NearTiesOf : public testing::TestWithParam<uint64_t> {};

TEST_P(NearTiesOf, AllPixelsAreDecidedAlikeByAllKernels) {
  constexpr uint64_t kSeeds = 100;
  for (uint64_t seed = GetParam() * kSeeds + 1; seed <= (GetParam() + 1) * kSeeds; ++seed) {
    spec::Random random(seed);
    std::vector<selvage_vertex> polygon = far_quad(random);
    if (random.percent(40)) narrow(&polygon, random.in(1, 40));
    if (random.percent(30)) polygon.pop_back();
    const selvage_filter filter = random.pick({SELVAGE_FILTER_NEAREST, SELVAGE_FILTER_NEAREST,
                                               SELVAGE_FILTER_FOUR, SELVAGE_FILTER_BILINEAR});
    ASSERT_NO_FATAL_FAILURE(expect_near_ties_alike(polygon, {.filter = filter}, seed));
  }
}

// In perspective, but by so little that u and v are next to the whole numbers that they would be
// without: every sample, or every second, fourth, ... one of a row and of a column. Denominators
// are of all sizes.
[[nodiscard]] std::vector<selvage_vertex> almost_affine_triangle(spec::Random& random,
                                                                 int32_t side_px,
                                                                 int32_t magnified_log2) {
  const int32_t q = 1 << random.in(1, 25);
  const bool across = random.percent(50), mirrored = random.percent(50);
  const int32_t least_q = q - (random.percent(80) ? 1 : 0);
  const auto corner = [&](int32_t right, int32_t below) {
    const auto texel_fx16 = [&](int32_t cells) {
      const int64_t u_fx16 =
          (int64_t{cells} * side_px * (1 << kTexelFraction) + (1 << (kTexelFraction - 1))) >>
          magnified_log2;
      return static_cast<int32_t>(mirrored ? -u_fx16 : u_fx16) + random.in(-1, 2);
    };
    return selvage_vertex{right * side_px * kSubpixels, below * side_px * kSubpixels,
                          texel_fx16(across ? below : right), texel_fx16(right),
                          random.percent(50) ? q : least_q};
  };
  return {corner(0, 0), corner(1, 0), corner(0, 1)};
}

class NearTiesInPerspective : public testing::TestWithParam<uint64_t> {};

TEST_P(NearTiesInPerspective, AllPixelsAreDecidedAlikeByAllKernels) {
  constexpr uint64_t kSeeds = 50;
  constexpr int32_t kTall_px = 150;  // more than a batch of rows
  for (uint64_t seed = GetParam() * kSeeds + 1; seed <= (GetParam() + 1) * kSeeds; ++seed) {
    spec::Random random(seed);
    const int32_t side_px = random.pick({16, 50, 64, 300, 1024, 8192, kFar_px});
    const auto triangle = almost_affine_triangle(random, side_px, random.in(0, 9));
    ASSERT_NO_FATAL_FAILURE(expect_near_ties_alike(triangle, {.height_px = kTall_px}, seed));
  }
}

INSTANTIATE_TEST_SUITE_P(Block, NearTiesInPerspective, testing::Range(uint64_t{0}, uint64_t{8}));

// Narrow, or so where it is seen, and with a few texels alone, anywhere in the texture or beyond
// it: or u and v are the same whole numbers everywhere, but for a little, and q may be anything.
// Denominators are of all sizes.
[[nodiscard]] std::vector<selvage_vertex> triangle_of_few_texels(spec::Random& random) {
  auto triangle = almost_affine_triangle(random, random.in(2, 65), random.in(2, 9));
  const bool is_point = random.percent(40), is_within = random.percent(75);
  const bool is_tip = is_point && random.percent(50);
  const int32_t times_as_tall = random.pick({1, 1, 1, kFar_px / 64 - 1});
  const int32_t times_as_wide = is_tip ? times_as_tall : 1;
  const int32_t right_px = random.in(0, 100), down_px = random.in(0, 40);
  if (is_tip) triangle[1].y = triangle[2].y;
  for (selvage_vertex& vertex : triangle) {
    vertex.x = vertex.x * times_as_wide + right_px * kSubpixels;
    vertex.y = vertex.y * times_as_tall + down_px * kSubpixels;
    if (is_point) {
      vertex.u = random.in(-6, 3);
      vertex.v = random.in(-6, 3);
      vertex.q = random.percent(70) ? random.in(1 << 20, SELVAGE_Q_MAX) : 1 << random.in(0, 25);
    }
  }
  for (int32_t selvage_vertex::*of : {&selvage_vertex::u, &selvage_vertex::v}) {
    const auto [least, most] = std::ranges::minmax(triangle, {}, of);
    const int32_t first_texel = -(least.*of >> kTexelFraction);
    const int32_t last_texel = kNearTiesTexture_texel - 1 - (most.*of >> kTexelFraction);
    const int32_t shift_texel =
        is_within ? random.in(first_texel, last_texel + 1) : random.in(-40, 41);
    for (selvage_vertex& vertex : triangle) vertex.*of += shift_texel * (1 << kTexelFraction);
  }
  return triangle;
}

class NearTiesOfFewTexels : public testing::TestWithParam<uint64_t> {};

TEST_P(NearTiesOfFewTexels, AllPixelsAreDecidedAlikeByAllKernels) {
  constexpr uint64_t kSeeds = 100;
  constexpr int32_t kTall_px = 104;
  for (uint64_t seed = GetParam() * kSeeds + 1; seed <= (GetParam() + 1) * kSeeds; ++seed) {
    spec::Random random(seed);
    const std::vector<selvage_vertex> triangle = triangle_of_few_texels(random);
    const auto format = random.pick({SELVAGE_INDEX8, SELVAGE_RGB565, SELVAGE_RGBA8888});
    ASSERT_NO_FATAL_FAILURE(
        expect_near_ties_alike(triangle, {.height_px = kTall_px, .format = format}, seed));
  }
}

INSTANTIATE_TEST_SUITE_P(Block, NearTiesOfFewTexels, testing::Range(uint64_t{0}, uint64_t{8}));

// Boxes of two texels: u changes by as much from row to row as from pixel to pixel.
class NearTiesOfBoxes : public testing::TestWithParam<uint64_t> {};

TEST_P(NearTiesOfBoxes, AllPixelsAreDecidedAlikeByAllKernels) {
  constexpr uint64_t kSeeds = 20;
  for (uint64_t seed = GetParam() * kSeeds + 1; seed <= (GetParam() + 1) * kSeeds; ++seed) {
    spec::Random random(seed);
    std::vector<selvage_vertex> polygon = far_quad(random);
    const int32_t across_fx16 = polygon[1].u - polygon[0].u;
    for (selvage_vertex& vertex : polygon) {
      if (vertex.y != 0) vertex.u -= across_fx16;
    }
    if (random.percent(50)) polygon.pop_back();
    ASSERT_NO_FATAL_FAILURE(expect_near_ties_alike(polygon, {.filter = SELVAGE_FILTER_AREA}, seed));
  }
}

INSTANTIATE_TEST_SUITE_P(Block, NearTiesOfBoxes, testing::Range(uint64_t{0}, uint64_t{10}));
INSTANTIATE_TEST_SUITE_P(Block, NearTiesOf, testing::Range(uint64_t{0}, uint64_t{15}));

// q from the least to 2^24 and back, over `width_px` columns whose first centre has the least.
[[nodiscard]] SpanMap steep(int32_t width_px, bool grows, int32_t least_q = 1) {
  const auto at = [&](int32_t x_px, int32_t q) {
    return EdgePoint{.height = 256,
                     .x = (int64_t{x_px} * kSubpixels + kHalfPixel) * 256,
                     .uq = int128{x_px} * 65536 * q * 256,
                     .vq = int128{7 - x_px} * 30000 * q * 256,
                     .q = int64_t{q} * 256};
  };
  const int32_t first_q = grows ? least_q : SELVAGE_Q_MAX;
  const int32_t last_q = grows ? SELVAGE_Q_MAX : least_q;
  return {at(0, first_q), at(width_px, last_q)};
}

// A longer piece might be steeper, if the denominator were steeper still: by the offsets of its
// ends from the lesser end of the span.
void expect_as_long_as_may_be(const SpanMap& map, const Span& span, const Span& piece) {
  const bool grows = map.denominator_step() > 0;
  const int32_t first = grows ? piece.left_px - span.left_px : span.right_px - piece.right_px;
  const int32_t end = first + piece.width_px();
  if (end == span.width_px()) return;
  EXPECT_EQ(end, first == 0 ? 1 : first * kGentleRatio + 1);
}

TEST(NearTies, AreFewInPiecesOfSteepSpans) {
  for (const int32_t width_px : {1, 2, 3, 1024, 1025, 1026, 40000, 65536}) {
    for (const bool grows : {false, true}) {
      const SpanMap map = steep(width_px, grows);
      const Span span{0, grows ? 0 : 1, grows ? width_px : width_px + 1};
      int32_t pieces = 0, pixels = 0;
      for_each_gentle_piece(span, grows, [&](const Span& piece) {
        ++pieces;
        pixels += piece.width_px();
        EXPECT_EQ(grows ? piece.right_px : span.right_px - piece.left_px,
                  span.left_px * grows + pixels);
        EXPECT_LE(ProjectiveLanes(map, piece).ratio(), kGentleRatio * (1 + 1e-9));
        expect_as_long_as_may_be(map, span, piece);
      });
      EXPECT_EQ(pixels, width_px);
      EXPECT_LE(pieces, kMostPieces);
    }
  }
}

void expect_alike_over_a_steep_span(int32_t least_q) {
  const SpanMap map = steep(kTargetWidth_px, true, least_q);
  const Span whole{0, 0, kTargetWidth_px};
  const ProjectiveLanes lanes(map, whole);
  ASSERT_GE(lanes.margin_fx32(), (1U << 24) / static_cast<uint32_t>(least_q));
  std::vector<uint32_t> texels(64 * 64);
  for (size_t i = 0; i < texels.size(); ++i) texels[i] = static_cast<uint32_t>(i) * 2654435761U;
  for (const selvage_filter filter : {SELVAGE_FILTER_FOUR, SELVAGE_FILTER_BILINEAR}) {
    std::vector<std::vector<uint32_t>> rows;
    for (selvage_kernel kernel = SELVAGE_KERNEL_SCALAR; kernel <= SELVAGE_KERNEL_NEON; ++kernel) {
      if (!is_usable(kernel)) continue;
      std::vector<uint32_t>& row = rows.emplace_back(kTargetWidth_px);
      const Surface surface{
          {row.data(), kTargetWidth_px, 1, kTargetWidth_px * 4, SELVAGE_RGBA8888},
          {texels.data(), 64, 64, 64 * 4, SELVAGE_RGBA8888, SELVAGE_LAYOUT_ROWS, nullptr},
          SELVAGE_ADDRESS_WRAP};
      kernels_for({SELVAGE_PROFILE_EXACT, filter, SELVAGE_ADDRESS_WRAP, 0, kernel}, surface.texture,
                  {})
          .draw_projective({one_span(whole), lanes.field(whole), kFarApart, ExactMap(map)},
                           surface);
      EXPECT_EQ(row, rows.front()) << "kernel " << kernel << ", least q " << least_q;
    }
  }
}

// Far steeper than what is drawn: lanes lack little less than a step of the filters' grid.
TEST(NearTies, MayBeAllPixelsOfASpan) {
  for (const int32_t least_q : {3, 4}) expect_alike_over_a_steep_span(least_q);
}

// Triangles on one texel's corner, far taller than the target and leaning left or right: rows begin
// on either side of the first one's pixel. In perspective, by odd numbers, so that no low bits of
// their large numerators are 0.
[[nodiscard]] std::vector<selvage_vertex> leaning_triangle(spec::Random& random) {
  const int32_t width_px = random.in(4, 60), far_px = random.in(3000, kFar_px);
  const int32_t lean_px = random.in(-far_px / 4, far_px / 4 + 1);
  const int32_t texel = random.in(1, 31);
  std::vector<selvage_vertex> triangle;
  for (const auto& [x_px, y_px] :
       {std::pair(100, 0), std::pair(100 + width_px, 0), std::pair(100 + lean_px, far_px)}) {
    const int32_t u_fx16 = texel * SELVAGE_SUBTEXELS + random.in(-3, 2);
    const int32_t v_fx16 = texel * SELVAGE_SUBTEXELS + random.in(-3, 2);
    triangle.push_back({x_px * SELVAGE_SUBPIXELS + random.in(0, 256),
                        y_px * SELVAGE_SUBPIXELS + random.in(0, 256), u_fx16, v_fx16,
                        SELVAGE_Q_MAX - random.in(1, 5000)});
  }
  return triangle;
}

TEST(NearTies, OfLeaningTrianglesAreDecidedAlikeByAllKernels) {
  for (uint64_t seed = 1; seed <= 600; ++seed) {
    spec::Random random(seed);
    const std::vector<selvage_vertex> triangle = leaning_triangle(random);
    ASSERT_NO_FATAL_FAILURE(expect_near_ties_alike(triangle, {.height_px = 104}, seed));
  }
}

// Quads on one texel's corner, whose rows have each a map of their own: from one window, some rows
// at once, and row by row; texels in the texture of 32 x 32 and beyond it. Denominators are of all
// sizes, for some reach far beyond the target.
[[nodiscard]] std::vector<selvage_vertex> quad_on_a_point(spec::Random& random) {
  const int32_t side_px = random.pick({3, 8, 16, 30, 33, 64, 65, 200, 299});
  const int32_t height_px = random.pick({2, 4, 6, 40, 40, kFar_px >> random.in(0, 8)});
  const int32_t texel = random.pick({1, 9, 9, 20, 31, 32, 40, -3});
  const int32_t off_fx16 = random.pick({0, 0, -1, 1, -2});
  const int32_t far = random.pick({0, 0, 1, 5, 20});  // texels that u goes on to
  const bool deep = random.percent(50);
  const int32_t q = deep ? SELVAGE_Q_MAX >> random.pick({0, 1, 8}) : random.pick({1, 1000});
  std::vector<selvage_vertex> quad;
  for (const auto& [right, below] :
       {std::pair(0, 0), std::pair(1, 0), std::pair(1, 1), std::pair(0, 1)}) {
    const int32_t slant_px = below * random.pick({0, 0, 1, 7});
    const int32_t point_fx16 = texel * SELVAGE_SUBTEXELS + off_fx16;
    quad.push_back(
        {(right * side_px + slant_px) * SELVAGE_SUBPIXELS, below * height_px * SELVAGE_SUBPIXELS,
         point_fx16 + right * far * SELVAGE_SUBTEXELS - right * below,
         point_fx16 - below * random.in(0, 2), deep ? q - right * (q / 16) - right * below : q});
  }
  return quad;
}

TEST(NearTies, OfRowsInNoPlaneAreDecidedAlikeByAllKernels) {
  for (uint64_t seed = 1; seed <= 3000; ++seed) {
    spec::Random random(seed);
    const std::vector<selvage_vertex> quad = quad_on_a_point(random);
    ASSERT_NO_FATAL_FAILURE(expect_near_ties_alike(
        quad,
        {.height_px = random.pick({40, 66}),  // the last batch of 66 rows has two
         .format = random.pick({SELVAGE_INDEX8, SELVAGE_RGB565, SELVAGE_RGBA8888})},
        seed));
  }
}

}  // namespace
}  // namespace selvage::mapper
