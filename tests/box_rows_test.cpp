// Rows of boxes whose sides or points doubles and lanes cannot decide: against the model, pixel for
// pixel.
#include <gtest/gtest.h>

#include <utility>
#include <vector>

#include "mapper/kernel.h"
#include "mapper/plane.h"
#include "mapper/polygon.h"
#include "mapper/projective_plane.h"
#include "mapper/vector/kernel.h"
#include "spec/picture.h"
#include "tests/modelled.h"

namespace selvage::mapper {
namespace {

using spec::Case;

[[nodiscard]] Case area_case_on_square(int32_t width_px, int32_t height_px, int32_t texture_texel) {
  Case c;
  c.filter = SELVAGE_FILTER_AREA;
  c.address = SELVAGE_ADDRESS_WRAP;
  c.target_width_px = width_px;
  c.target_height_px = height_px;
  c.texture_width_texel = c.texture_height_texel = texture_texel;
  return c;
}

[[nodiscard]] uint32_t noise(spec::Texel at) {
  return (static_cast<uint32_t>(at.s) * 40503U + static_cast<uint32_t>(at.t) * 7919U) * 2654435761U;
}
// 0 and 1 by turns, either way: half of each is rounded up, anything less down.
[[nodiscard]] uint32_t stripes(spec::Texel at) {
  return (at.s % 2 == 0 ? 0x00000101U : 0U) | (at.t % 2 == 0 ? 0x01010000U : 0U);
}

// One map for all rows, and numbers that vectors hold: they find the sides and points of boxes.
[[nodiscard]] bool is_for_vectors(const Case& c) {
  Polygon polygon;
  EXPECT_EQ(examine(c.vertices, &polygon), SELVAGE_OK);
  if (!lanes_fit(polygon)) return false;
  const selvage_rect visible{0, 0, c.target_width_px, c.target_height_px};
  return polygon.affine ? Plane::of(polygon, part_of(polygon, visible)).has_value()
                        : ProjectivePlane::of(polygon, visible).has_value();
}

void expect_vectors_as_modelled(const Case& c, const spec::TexelAt& texel_at) {
  ASSERT_TRUE(is_for_vectors(c));
  expect_drawn_as_modelled(c, texel_at);
}

[[nodiscard]] Case turned(Case c) {
  for (selvage_vertex& vertex : c.vertices) std::swap(vertex.u, vertex.v);
  return c;
}

// q and v change from row to row alone, so that boxes are as high all along a row.
struct Depth {
  int32_t rows, top_q, bottom_q, top_v, bottom_v;
};
[[nodiscard]] Case level(const Depth& depth, int32_t width_px, int32_t texture_texel) {
  Case c = area_case_on_square(width_px, depth.rows, texture_texel);
  const int32_t right_px = 4 * width_px;
  c.vertices = {{0, 128, 0, depth.top_v, depth.top_q},
                {right_px * 256, 128, right_px * 20000, depth.top_v, depth.top_q},
                {0, 128 + 256 * depth.rows, 0, depth.bottom_v, depth.bottom_q}};
  return c;
}

// At row 2 of 6, where q goes from 1 to 2, a side is 3/4096 of how far v goes.
TEST(BoxRow, HasSidesThatAreWholeInEveryPixel) {
  for (const int32_t side_fx8 : {258, 300, 1023, 3072}) {
    const Depth depth{6, 1 << 19, 1 << 20, -100000, side_fx8 / 3 * 4096 - 100000};
    const Case c = level(depth, 150, 64);
    for (const Case& each : {c, turned(c)}) {
      expect_vectors_as_modelled(each, noise);
      ASSERT_FALSE(HasFatalFailure()) << side_fx8;
    }
  }
}

// At one row a side is whole and about 10^-10 more, so that it counts as one more. As it is, it
// would be an even number of stripes, and as much of either.
TEST(BoxRow, HasSidesThatAreBarelyMoreThanWhole) {
  constexpr int32_t kTop = -(1 << 30);
  for (const Depth& depth : {Depth{5, 128437, 511461, kTop, kTop + 1512178101},
                             Depth{19, 874065, 805396, kTop, kTop + 1686057655}}) {
    for (int32_t half_texels = 0; half_texels < 4; ++half_texels) {
      Depth moved = depth;
      moved.top_v += half_texels << 15;
      moved.bottom_v += half_texels << 15;
      const Case c = level(moved, 12, 2);
      for (const Case& each : {c, turned(c)}) {
        expect_vectors_as_modelled(each, stripes);
        ASSERT_FALSE(HasFatalFailure()) << half_texels;
      }
    }
  }
}

// u goes so fast in the first column that its boxes would be longer than the longest, which holds
// as much of either stripe; in the last one it hardly goes.
TEST(BoxRow, HasNoLongerSidesThanTheLongest) {
  constexpr int32_t kRight = 20 * 256, kRoom_fx16 = 8 << 16;
  constexpr int32_t kMost_u = INT32_MAX - kRoom_fx16;
  for (int32_t half_texels = 0; half_texels < 4; ++half_texels) {
    Case c = area_case_on_square(20, 4, 2);
    const int32_t left_u = INT32_MIN + kRoom_fx16 + (half_texels << 15), near = SELVAGE_Q_MAX / 64;
    c.vertices = {{128, 0, left_u, 0, near},
                  {kRight, 0, kMost_u, 0, SELVAGE_Q_MAX},
                  {kRight, 1024, kMost_u, 0, SELVAGE_Q_MAX},
                  {128, 1024, left_u, 0, near}};
    for (const Case& each : {c, turned(c)}) {
      expect_vectors_as_modelled(each, stripes);
      ASSERT_FALSE(HasFatalFailure()) << half_texels;
    }
  }
}

// Both q and u change along the row: boxes of 3 texels and less, then of one.
TEST(BoxRow, HasSidesThatChangeAlongIt) {
  Case c = area_case_on_square(150, 4, 64);
  c.vertices = {{0, 0, 0, 0, 1 << 20},
                {300 * 256, 0, 300 * 65536, 40 * 65536, 3 << 20},
                {0, 300 * 256, 0, 200 * 65536, 1 << 20}};
  for (const Case& each : {c, turned(c)}) expect_vectors_as_modelled(each, noise);
}

// An affine map of a texel and a half a pixel, from a polygon so wide that a change of u by 1/65536
// texel at its far end leaves points barely beside those of the grid.
TEST(BoxRow, HasPointsThatAreBarelyBesideTheGrid) {
  constexpr int32_t kFar_px = 32766, kHalf_fx16 = kFar_px * 49152;
  for (const int32_t sign : {1, -1}) {
    for (const int32_t nudge : {-1, 0, 1}) {
      Case c = area_case_on_square(150, 3, 64);
      const int32_t left = -sign * kHalf_fx16, right = sign * kHalf_fx16 + nudge;
      c.vertices = {{0, 0, left, left, 1},
                    {kFar_px * 256, 0, right, right, 1},
                    {kFar_px * 256, 4096, right, right, 1},
                    {0, 4096, left, left, 1}};
      expect_vectors_as_modelled(c, noise);
      ASSERT_FALSE(HasFatalFailure()) << sign << ", " << nudge;
    }
  }
}

// Of almost the largest area, so that the numbers that decide points are as long as they get, and
// beside the grid by a share of x.
TEST(BoxRow, HasPointsThatAreBarelyBesideTheGridUnderTheLargestMaps) {
  constexpr int32_t kFar_fx8 = 32000 * 256, kFar_fx16 = 32000 << 16;
  for (const int32_t sign : {1, -1}) {
    for (const int32_t nudge : {-1, 0, 1}) {
      Case c = area_case_on_square(150, 3, 64);
      const int32_t first = sign * -kFar_fx16 + nudge, last = sign * kFar_fx16 - nudge;
      c.vertices = {{-kFar_fx8, -kFar_fx8, first, first, 1},
                    {kFar_fx8, -kFar_fx8, last, last, 1},
                    {0, kFar_fx8, sign * kFar_fx16, sign * kFar_fx16, 1}};
      expect_vectors_as_modelled(c, noise);
      ASSERT_FALSE(HasFatalFailure()) << sign << ", " << nudge;
    }
  }
}

}  // namespace
}  // namespace selvage::mapper
