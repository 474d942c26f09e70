#include "historic/classroom.h"

#include <gtest/gtest.h>

#include <array>

#include "spec/historic_line.h"
#include "support.h"

namespace selvage::historic {
namespace {

using spec::Case;
using spec::Rational;
using spec::Texel;
using test::case_of;
using test::drawn;
using test::drawn_px;
using test::texel_at;

inline constexpr selvage_profile kDkit = SELVAGE_PROFILE_DKIT;

[[nodiscard]] Rational fraction(int numerator, int denominator) {
  Rational value(numerator, denominator);
  value.canonicalize();
  return value;
}

// The worked example of the notes: a texture of 60 x 20 on the quadrilateral V1 .. V4. The notes
// give the rows of the vertices and two edge positions on scan line 15; these columns have both.
//
// Where the notes differ from the fractions below, they slipped:
//   row 17 of the table along V4V3     v is printed as 15; 7 rows of 2 are 14
//   signs are lost                     the steps of T are -20 along V4V1 and -6 along V3V2, both
//                                      from 60 to 0; along scan line 15 they are -4 and -8/15
[[nodiscard]] Case worked_example() {
  Case c = case_of(kDkit, {{27, 13, 0, 0}, {20, 30, 0, 20}, {6, 20, 60, 20}, {15, 10, 60, 0}});
  c.texture_width_texel = 61;  // one more each way, so that u = 60 and v = 20 are told
  c.texture_height_texel = 21;
  return c;
}

TEST(Classroom, WorkedExampleAlongItsEdges) {
  const Case c = worked_example();
  for (int32_t row = 13; row <= 20; ++row) {
    const auto line = spec::historic_line(kDkit, c.vertices, row);
    const auto &left = line->left, &right = line->right;
    if (row < 20) {  // V4V3: (0, 2) a row; on row 20 V3V2 begins with V3's texel
      EXPECT_EQ(left.u, 60);
      EXPECT_EQ(left.v, 2 * (row - 10));
    }
    EXPECT_EQ(right.u, 0);  // V1V2: (0, 20/17) a row
    EXPECT_EQ(right.v, fraction(20 * (row - 13), 17));
  }
  for (int32_t row = 10; row < 13; ++row) {  // V4V1: (-20, 0) a row
    const auto line = spec::historic_line(kDkit, c.vertices, row);
    const auto& v4v1 = line->left.x < line->right.x ? line->right : line->left;
    EXPECT_EQ(v4v1.u, 60 - 20 * (row - 10));
    EXPECT_EQ(v4v1.v, 0);
  }
  for (int32_t row = 20; row < 30; ++row) {  // V3V2: (-6, 0) a row
    const auto line = spec::historic_line(kDkit, c.vertices, row);
    EXPECT_EQ(line->left.u, 60 - 6 * (row - 20));
    EXPECT_EQ(line->left.v, 20);
  }
}

TEST(Classroom, WorkedExampleOnScanLine15) {
  const Case c = worked_example();
  const auto line = spec::historic_line(kDkit, c.vertices, 15);
  EXPECT_EQ(line->left.x, fraction(21, 2));
  EXPECT_EQ(line->left.column_px, 11);
  EXPECT_EQ(line->right.x, fraction(445, 17));  // 26.17647
  EXPECT_EQ(line->right.column_px, 26);
  EXPECT_EQ(line->right.v, fraction(40, 17));  // 2.3529
  EXPECT_EQ(line->right.v_fx16, 2 * SELVAGE_SUBTEXELS);

  const spec::Picture picture = drawn(c);
  constexpr std::array<int32_t, 16> kV = {10, 9, 9, 8, 8, 7, 7, 6, 6, 5, 5, 4, 4, 3, 3, 2};
  for (int32_t k = 0; k < 16; ++k) {
    EXPECT_EQ(texel_at(picture, 11 + k, 15), (Texel{60 - 4 * k, kV[static_cast<size_t>(k)]})) << k;
    const Rational exact = 10 - fraction(8 * k, 15);
    EXPECT_EQ(spec::floor(exact + fraction(1, 2)), kV[static_cast<size_t>(k)]);
  }
  EXPECT_EQ(texel_at(picture, 10, 15), (Texel{-1, -1}));
  EXPECT_EQ(texel_at(picture, 27, 15), (Texel{-1, -1}));
}

// V4V3 reaches (60, 20) on row 20, where V3V2 takes over with the same texel.
TEST(Classroom, WorkedExampleDownItsLeftSide) {
  const spec::Picture picture = drawn(worked_example());
  for (int32_t row = 10; row <= 20; ++row) {
    const auto line = spec::historic_line(kDkit, worked_example().vertices, row);
    EXPECT_EQ(texel_at(picture, line->left.column_px, row), (Texel{60, 2 * (row - 10)})) << row;
  }
}

TEST(Classroom, DrawsBothEndsAndTheLastRow) {
  const spec::Picture picture =
      drawn(case_of(kDkit, {{2, 3, 0, 0}, {7, 3, 5, 0}, {7, 9, 5, 6}, {2, 9, 0, 6}}));
  EXPECT_EQ(drawn_px(picture), 6U * 7U);
  EXPECT_EQ(texel_at(picture, 7, 9), (Texel{5, 6}));
}

TEST(Classroom, DrawsALineOfNoWidthButNotOfNoHeight) {
  EXPECT_EQ(drawn_px(drawn(case_of(kDkit, {{5, 3, 0, 0}, {5, 9, 9, 9}, {5, 6, 4, 4}}))), 7U);
  EXPECT_EQ(drawn_px(drawn(case_of(kDkit, {{5, 3, 0, 0}, {9, 3, 9, 9}, {7, 3, 4, 4}}))), 0U);
}

TEST(Classroom, EitherWindingIsTheSamePicture) {
  const std::vector<test::Corner> corners = {{3, 2, 0, 0}, {30, 8, 20, 0}, {9, 33, 0, 20}};
  const spec::Picture one = drawn(case_of(kDkit, corners));
  const spec::Picture other = drawn(case_of(kDkit, {corners.rbegin(), corners.rend()}));
  EXPECT_GT(drawn_px(one), 300U);
  EXPECT_EQ(one.pixels, other.pixels);
}

// Two rectangles that share an upright edge both draw its pixels.
TEST(Classroom, DrawsSharedEdgesTwice) {
  const spec::Picture left =
      drawn(case_of(kDkit, {{2, 3, 0, 0}, {7, 3, 5, 0}, {7, 9, 5, 6}, {2, 9, 0, 6}}));
  const spec::Picture right =
      drawn(case_of(kDkit, {{7, 3, 0, 0}, {12, 3, 5, 0}, {12, 9, 5, 6}, {7, 9, 0, 6}}));
  int32_t twice = 0;
  for (size_t i = 0; i < left.pixels.size(); ++i) twice += left.pixels[i] && right.pixels[i];
  EXPECT_EQ(twice, 7);
}

}  // namespace
}  // namespace selvage::historic
