#include "spec/filter.h"

#include <gtest/gtest.h>

#include "spec/generate.h"
#include "spec/picture.h"

namespace selvage::spec {
namespace {

[[nodiscard]] Rational ratio(int64_t numerator, int64_t denominator) {
  Rational r(numerator, denominator);
  r.canonicalize();
  return r;
}

TEST(Taps, OfNearestIsTheTexelOfU) {
  EXPECT_EQ(taps(SELVAGE_FILTER_NEAREST, ratio(7, 2), 256), (Taps{{3, 1}}));
  EXPECT_EQ(taps(SELVAGE_FILTER_NEAREST, ratio(-1, 9), 256), (Taps{{-1, 1}}));
}

TEST(Taps, OfFourAreTheTwoAroundU) {
  EXPECT_EQ(taps(SELVAGE_FILTER_FOUR, ratio(7, 2), 256), (Taps{{3, 1}, {4, 1}}));
  EXPECT_EQ(taps(SELVAGE_FILTER_FOUR, ratio(699, 200), 256), (Taps{{2, 1}, {3, 1}}));
}

TEST(Taps, OfBilinearWeighByTheFloorOfTheFraction) {
  EXPECT_EQ(taps(SELVAGE_FILTER_BILINEAR, ratio(7, 2), 256), (Taps{{3, 256}}));
  EXPECT_EQ(taps(SELVAGE_FILTER_BILINEAR, ratio(7, 2) + ratio(1, 256), 256),
            (Taps{{3, 255}, {4, 1}}));
  EXPECT_EQ(taps(SELVAGE_FILTER_BILINEAR, ratio(7, 2) + ratio(2, 257), 256),
            (Taps{{3, 255}, {4, 1}}));
  EXPECT_EQ(taps(SELVAGE_FILTER_BILINEAR, ratio(1, 4), 256), (Taps{{-1, 64}, {0, 192}}));
}

TEST(Taps, OfAreaAreABoxAroundU) {
  EXPECT_EQ(taps(SELVAGE_FILTER_AREA, ratio(1, 4), 256),
            taps(SELVAGE_FILTER_BILINEAR, ratio(1, 4), 256));
  // 2 texels around u = 3: from 2 to 4; 2.5 texels: from 1 3/4 to 4 1/4.
  EXPECT_EQ(taps(SELVAGE_FILTER_AREA, 3, 512), (Taps{{2, 256}, {3, 256}}));
  EXPECT_EQ(taps(SELVAGE_FILTER_AREA, 3, 640), (Taps{{1, 64}, {2, 256}, {3, 256}, {4, 64}}));
}

TEST(BoxSide, IsTheScaleRoundedUpBetweenItsEnds) {
  EXPECT_EQ(box_side_fx8(0), 256);
  EXPECT_EQ(box_side_fx8(1), 256);
  EXPECT_EQ(box_side_fx8(ratio(257, 256)), 257);
  EXPECT_EQ(box_side_fx8(ratio(25601, 25600)), 257);
  EXPECT_EQ(box_side_fx8(65535 + ratio(1, 1000)), 65535 * 256 + 1);
  EXPECT_EQ(box_side_fx8(65536), kMostBoxSide_fx8);
  EXPECT_EQ(box_side_fx8(Rational("123456789123456789")), kMostBoxSide_fx8);
}

TEST(Addressed, JoinsTapsOfOneTexel) {
  const Taps around = {{-2, 5}, {-1, 7}, {0, 11}, {1, 13}};
  EXPECT_EQ(addressed(around, 2, SELVAGE_ADDRESS_CLAMP), (Taps{{0, 23}, {1, 13}}));
  EXPECT_EQ(addressed(around, 2, SELVAGE_ADDRESS_WRAP), (Taps{{0, 16}, {1, 20}}));
  EXPECT_EQ(addressed(around, 3, SELVAGE_ADDRESS_WRAP), (Taps{{0, 11}, {1, 18}, {2, 7}}));
}

// All filters round by the same rule, which in their own formulas is + 2 >> 2 and + 32768 >> 16.
TEST(WeightedMean, IsTheFormulaOfEachFilter) {
  const uint32_t texels[] = {3, 200, 91, 254};
  const auto texel_at = [&](Texel t) { return texels[t.t * 2 + t.s]; };
  for (int64_t a = 0; a <= 256; a += 4) {
    for (int64_t b = 0; b <= 256; b += 4) {
      const int64_t sum =
          (256 - a) * (256 - b) * 3 + a * (256 - b) * 200 + (256 - a) * b * 91 + a * b * 254;
      ASSERT_EQ(weighted_mean({{0, 256 - a}, {1, a}}, {{0, 256 - b}, {1, b}}, texel_at),
                (sum + 32768) >> 16);
    }
  }
  EXPECT_EQ(weighted_mean({{0, 1}, {1, 1}}, {{0, 1}, {1, 1}}, texel_at),
            (3U + 200 + 91 + 254 + 2) >> 2);
}

TEST(WeightedMean, TakesChannelsApart) {
  const auto texel_at = [](Texel t) { return t.s == 0 ? 0xFF00FF00U : 0x00FF00FFU; };
  EXPECT_EQ(weighted_mean({{0, 1}, {1, 1}}, {{0, 1}}, texel_at), 0x80808080U);
  EXPECT_EQ(weighted_mean({{0, 3}, {1, 1}}, {{0, 1}}, texel_at), 0xBF40BF40U);
}

// What the filters have in common is what the texts about them say.
void expect_bilinear_areas(int seeds) {
  int compared = 0;
  for (uint64_t seed = 0; seed < static_cast<uint64_t>(seeds); ++seed) {
    Case c = generate(seed);
    c.format = SELVAGE_RGBA8888;
    if (validity(c.vertices) != SELVAGE_OK) continue;
    for (int32_t y = 0; y < c.target_height_px; y += 3) {
      for (int32_t x = 0; x < c.target_width_px; x += 3) {
        const auto point = sample(c.vertices, x, y);
        if (!point) continue;
        const BoxSides sides = box_sides(gradient(c.vertices, x, y).value());
        c.filter = SELVAGE_FILTER_AREA;
        const Weights area = filter_weights(c, x, y, *point);
        if (sides.u_fx8 != kLeastBoxSide_fx8 || sides.v_fx8 != kLeastBoxSide_fx8) continue;
        c.filter = SELVAGE_FILTER_BILINEAR;
        const Weights bilinear = filter_weights(c, x, y, *point);
        ASSERT_EQ(area.columns, bilinear.columns);
        ASSERT_EQ(area.rows, bilinear.rows);
        ++compared;
      }
    }
  }
  EXPECT_GT(compared, seeds * 2 / 3);
}

TEST(Filters, AreBilinearWhereNothingIsMinified) { expect_bilinear_areas(150); }
TEST(FiltersAtLength, AreBilinearWhereNothingIsMinified) { expect_bilinear_areas(1500); }

}  // namespace
}  // namespace selvage::spec
