#include "historic/two_stage.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "support.h"

namespace selvage::historic {
namespace {

using spec::Case;
using spec::Texel;
using test::case_of;
using test::drawn;
using test::drawn_px;
using test::texel_at;

inline constexpr selvage_profile k56 = SELVAGE_PROFILE_ABRASH56;
inline constexpr selvage_profile k57 = SELVAGE_PROFILE_ABRASH57;

// By hand: rows 1 .. 3; the left edge falls from (8, 1) to (2, 4), two columns a row; the right one
// is upright at 12. u runs from 0 to 12 along each row, in steps of 12 / width.
TEST(TwoStage, DrawsWhatWasWorkedOutByHand) {
  const Case c = case_of(k56, {{8, 1, 0, 0}, {12, 1, 12, 0}, {12, 4, 12, 9}, {2, 4, 0, 9}});
  const spec::Picture picture = drawn(c);
  EXPECT_EQ(drawn_px(picture), 4U + 6U + 8U);
  const Texel row1[] = {{0, 0}, {3, 0}, {6, 0}, {9, 0}};
  for (int32_t k = 0; k < 4; ++k) EXPECT_EQ(texel_at(picture, 8 + k, 1), row1[k]);
  for (int32_t k = 0; k < 6; ++k) EXPECT_EQ(texel_at(picture, 6 + k, 2), (Texel{2 * k, 3}));
  for (int32_t k = 0; k < 8; ++k) EXPECT_EQ(texel_at(picture, 4 + k, 3), (Texel{3 * k / 2, 6}));
}

// Steps of 10 / 3 are 218453 / 65536, a third of a unit short: 3 of them end below 10.
TEST(TwoStage, TruncatesItsSteps) {
  const Case c = case_of(k56, {{0, 0, 0, 0}, {6, 0, 20, 0}, {6, 2, 20, 2}, {0, 2, 0, 2}});
  const spec::Picture picture = drawn(c);
  EXPECT_EQ(texel_at(picture, 3, 0), (Texel{9, 0}));  // the exact u is 10
  EXPECT_EQ(texel_at(picture, 3, 1), (Texel{9, 1}));
}

TEST(TwoStage, DrawsClockwiseOnly) {
  for (const selvage_profile profile : {k56, k57}) {
    Case c = case_of(profile, {{3, 2, 0, 0}, {30, 8, 20, 0}, {9, 33, 0, 20}});
    EXPECT_GT(drawn_px(drawn(c)), 100U);
    std::ranges::reverse(c.vertices);
    const spec::Picture picture = drawn(c);
    EXPECT_EQ(picture.status, SELVAGE_OK);
    EXPECT_EQ(drawn_px(picture), 0U);
  }
}

TEST(TwoStage, DrawsNothingOfNoHeight) {
  for (const selvage_profile profile : {k56, k57}) {
    const spec::Picture flat =
        drawn(case_of(profile, {{3, 9, 0, 0}, {30, 9, 20, 0}, {12, 9, 3, 0}}));
    EXPECT_EQ(flat.status, SELVAGE_OK);
    EXPECT_EQ(drawn_px(flat), 0U);
    const spec::Picture two = drawn(case_of(profile, {{3, 2, 0, 0}, {30, 9, 20, 0}}));
    EXPECT_EQ(two.status, SELVAGE_ERROR_VERTEX_COUNT);
    EXPECT_EQ(drawn_px(two), 0U);
  }
}

TEST(TwoStage, RefusesFractionsAndPerspective) {
  for (const selvage_profile profile : {k56, k57, selvage_profile{SELVAGE_PROFILE_DKIT}}) {
    Case c = case_of(profile, {{3, 2, 0, 0}, {30, 8, 20, 0}, {9, 33, 0, 20}});
    c.vertices[1].x += 1;
    EXPECT_EQ(drawn(c).status, SELVAGE_ERROR_VERTEX_FRACTION);
    EXPECT_EQ(drawn_px(drawn(c)), 0U);
    c.vertices[1].x -= 1;
    c.vertices[2].q = 2;
    EXPECT_EQ(drawn(c).status, SELVAGE_ERROR_VERTEX_Q_DIFFERS);
    for (selvage_vertex& v : c.vertices) v.q = 77;
    EXPECT_EQ(drawn(c).status, SELVAGE_OK);
  }
}

// u = 64 on a texture of 64 columns is the texel past the row's end; here it is the row's last.
TEST(TwoStage, NeverReadsPastTheTexture) {
  const Case c = case_of(k56, {{2, 2, 64, 64}, {9, 2, 64, 64}, {9, 9, 64, 64}, {2, 9, 64, 64}});
  const spec::Picture picture = drawn(c);
  EXPECT_EQ(texel_at(picture, 5, 5), (Texel{63, 63}));
}

// The prestep spreads 3 texels over 9 pixels as 3, 3, 3; without it the last is never reached.
TEST(TwoStage, SequelSpreadsTexelsEvenly) {
  const std::vector<test::Corner> corners = {
      {0, 0, 0, 0}, {9, 0, 3, 0}, {9, 2, 3, 0}, {0, 2, 0, 0}};
  const spec::Picture before = drawn(case_of(k56, corners)), after = drawn(case_of(k57, corners));
  for (int32_t x = 0; x < 9; ++x) {
    EXPECT_EQ(texel_at(before, x, 0).s, std::max(0, (x * 21845) >> 16));
    EXPECT_EQ(texel_at(after, x, 0).s, (10922 + x * 21845 + 32768) >> 16);
  }
}

// As many texel centres as pixels are copied, although a 16.16 step would lose one of them.
TEST(TwoStage, SequelCopiesWhatIsOneToOneAtEveryWidth) {
  bool dda_would_fail = false;
  for (int32_t width = 1; width <= 700; ++width) {
    Case c = case_of(
        k57, {{0, 0, 0, 0}, {width, 0, width - 1, 0}, {width, 1, width - 1, 0}, {0, 1, 0, 0}});
    c.target_width_px = c.texture_width_texel = width;
    c.target_height_px = c.texture_height_texel = 1;
    const spec::Picture picture = drawn(c);
    for (int32_t x = 0; x < width; ++x) ASSERT_EQ(texel_at(picture, x, 0).s, x) << width;
    const auto line = spec::historic_line(k57, c.vertices, 0);
    for (int32_t x = 0; x < width; ++x) {
      dda_would_fail = dda_would_fail || spec::dda_texel(*line, x)->s != x;
    }
  }
  EXPECT_TRUE(dda_would_fail);
}

// Vertices that repeat or lie on an edge change nothing of what a rectangle is.
TEST(TwoStage, SequelCopiesWhatIsOneToOneWhateverItsVertices) {
  constexpr int32_t kWidth = 195;  // where 16.16 first loses a texel
  const test::Corner a{0, 0, 0, 0}, b{kWidth, 0, kWidth - 1, 0};
  const test::Corner c{kWidth, 2, kWidth - 1, 1}, d{0, 2, 0, 1};
  const test::Corner between{97, 0, 97, 0};
  const std::vector<test::Corner> outlines[] = {
      {a, b, c, d}, {a, a, b, c, d}, {a, b, c, d, d}, {a, between, b, c, d}};
  for (const std::vector<test::Corner>& outline : outlines) {
    Case shown = case_of(k57, outline);
    shown.target_width_px = shown.texture_width_texel = kWidth;
    shown.target_height_px = shown.texture_height_texel = 2;
    const spec::Picture picture = drawn(shown);
    for (int32_t x = 0; x < kWidth; ++x) {
      EXPECT_EQ(texel_at(picture, x, 1), (Texel{x, 1})) << outline.size() << " vertices";
    }
  }
}

// One to one along one axis alone is no copy.
TEST(TwoStage, SequelCopiesNothingElse) {
  constexpr int32_t kSide = 8;
  for (const bool across : {false, true}) {
    const int32_t u = across ? kSide - 1 : 3, v = across ? 3 : kSide - 1;
    const Case c = case_of(
        k57, {{0, 0, 0, 0}, {kSide, 0, u, 0}, {kSide, kSide, u, v}, {0, kSide, 0, v}}, kSide);
    EXPECT_EQ(drawn(c).pixels, spec::expected(c).pixels);
    const Texel last = texel_at(drawn(c), kSide - 1, kSide - 1);
    EXPECT_EQ(last, (across ? Texel{kSide - 1, 3} : Texel{3, kSide - 1}));
  }
}

}  // namespace
}  // namespace selvage::historic
