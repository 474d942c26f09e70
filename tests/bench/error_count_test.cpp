#include "reports/bench/error_count.h"

#include <gtest/gtest.h>

#include <cstdlib>

namespace selvage::reports {
namespace {

constexpr uint32_t kThreeBytes = 0x00FFFFFF;

// One pixel, which the model gives the texel (s, t) = (3, 256).
ErrorCount judge(uint32_t drawn, uint32_t carried_bits) {
  ModelRows model;
  model.rows_px = {0};
  model.pixels = {{{place_of(3, 256), 3.5, 256.5}}};
  Target target(1, 1);
  target.pixels[0] = drawn;
  return count_errors(model, target, true, SELVAGE_FILTER_NEAREST, carried_bits);
}

TEST(ErrorCount, AllBitsTellTheTexel) {
  EXPECT_EQ(judge(place_of(3, 256), 0xFFFFFFFF).total(), 0u);
  const ErrorCount far = judge(place_of(3, 0), 0xFFFFFFFF);
  EXPECT_EQ(far.wrong_texels, 1u);
  EXPECT_EQ(far.largest_texel, 256);
  EXPECT_EQ(judge(place_of(0, 256), 0xFFFFFFFF).largest_texel, 3);
}

TEST(ErrorCount, BitsThatAreNotCarriedAreNotCompared) {
  EXPECT_EQ(judge(place_of(3, 256) | 0xFF000000, kThreeBytes).total(), 0u);
  EXPECT_EQ(judge(place_of(3, 0), kThreeBytes).total(), 0u);  // t modulo 256
  EXPECT_EQ(judge(place_of(3, 256) | 0xFF000000, 0xFFFFFFFF).wrong_texels, 1u);
}

TEST(ErrorCount, TheNearestOfTheTexelsThatAPixelMayMeanIsMeant) {
  for (const int32_t t : {253, 255, 257, 300}) {
    const ErrorCount near = judge((place_of(3, t) & kThreeBytes) | 0xFF000000, kThreeBytes);
    EXPECT_EQ(near.wrong_texels, 1u) << t;
    EXPECT_EQ(near.largest_texel, std::abs(t - 256)) << t;
  }
  EXPECT_EQ(judge(place_of(7, 256) | 0xFF000000, kThreeBytes).largest_texel, 4);
}

TEST(ErrorCount, AnUntouchedPixelIsMissingInAnyBits) {
  EXPECT_EQ(judge(kUntouched, kThreeBytes).missing_px, 1u);
  EXPECT_EQ(judge(kUntouched, 0xFFFFFFFF).missing_px, 1u);
}

TEST(ErrorCount, APixelInThePaddingIsExtraBehindAnyRow) {
  constexpr int32_t width_px = 3, height_px = 4, padding_px = 5;
  ModelRows model;
  model.rows_px = {2};
  model.pixels = {std::vector<ModelPixel>(width_px)};
  for (int32_t y = 0; y < height_px; ++y) {
    for (int32_t x = width_px; x < width_px + padding_px; ++x) {
      Target target(width_px, height_px, padding_px);
      target.row(y)[x] = place_of(1, 1);
      const ErrorCount errors = count_errors(model, target, true, SELVAGE_FILTER_NEAREST);
      EXPECT_EQ(errors.extra_in_padding_px, 1u) << x << ", " << y;
      EXPECT_EQ(errors.extra_px, 1u);
      EXPECT_EQ(errors.total(), 1u);
      EXPECT_EQ(errors.judged_px, 3u);
    }
  }
}

// One filtered pixel of the colour 0xFF203040.
ErrorCount judge_filtered(uint32_t drawn, uint32_t carried_bits = 0xFFFFFFFF) {
  ModelRows model;
  model.rows_px = {0};
  model.pixels = {{{0xFF203040, 3.5, 256.5}}};
  Target target(1, 1);
  target.pixels[0] = drawn;
  return count_errors(model, target, true, kBilinear, carried_bits);
}

TEST(ErrorCount, AFilteredColourIsAsFarOffAsItsWorstChannel) {
  const ErrorCount far = judge_filtered(0xFF23283F);
  EXPECT_EQ(far.largest_level, 8);
  EXPECT_EQ(far.mean_level(), 8);
  EXPECT_EQ(far.wrong_colours, 1u);
  EXPECT_EQ(far.unequal_colours, 1u);
  EXPECT_EQ(far.wrong_texels, 0u) << "no texel was drawn";
  EXPECT_EQ(far.total(), 1u);
}

TEST(ErrorCount, ALevelIsRoundingButNotEqual) {
  for (const uint32_t drawn : {0xFF213040u, 0xFF1F2F41u}) {
    const ErrorCount near = judge_filtered(drawn);
    EXPECT_EQ(near.wrong_colours, 0u);
    EXPECT_EQ(near.unequal_colours, 1u);
    EXPECT_EQ(near.largest_level, 1);
    EXPECT_EQ(near.total(), 1u) << "what must be exact is not";
  }
  EXPECT_EQ(judge_filtered(0xFF223040).wrong_colours, 1u);
  EXPECT_EQ(judge_filtered(0xFF203040).total(), 0u);
}

TEST(ErrorCount, ChannelsThatAreNotCarriedAreNotCompared) {
  EXPECT_EQ(judge_filtered(0x00203040, kThreeBytes).total(), 0u);
  EXPECT_EQ(judge_filtered(0x00203040).largest_level, 255);
  EXPECT_EQ(judge_filtered(0x00203044, kThreeBytes).largest_level, 4);
}

}  // namespace
}  // namespace selvage::reports
