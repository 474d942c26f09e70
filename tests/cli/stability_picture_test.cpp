#include "cli/stability_picture.h"

#include <gtest/gtest.h>

#include "comparison_panels.h"

namespace selvage::cli::test {
namespace {

// Covers columns [1, 8) of rows [0, 8); texel (0, 0) everywhere.
[[nodiscard]] spec::Case scene() {
  spec::Case c;
  c.target_width_px = c.target_height_px = kSide_px;
  c.vertices = {{256, 0, 0, 0, 1}, {2048, 0, 0, 0, 1}, {2048, 2048, 0, 0, 1}, {256, 2048, 0, 0, 1}};
  return c;
}

// Row 0: extra at 0, right at 1, one texel off at 2, eight at 3, fifteen at 4; all else missing.
[[nodiscard]] stability::Contender painter() {
  const auto paint = [](const selvage_image* target, auto...) -> selvage_status {
    constexpr uint32_t texels[] = {0, 0, 1, 8, 15};
    for (size_t x = 0; x < std::size(texels); ++x)
      static_cast<uint32_t*>(target->pixels)[x] = texels[x];
    return SELVAGE_OK;
  };
  return {"painter",         "", stability::Promise::kNothing, SELVAGE_PROFILE_EXACT, false,
          {"painter", paint}};
}

[[nodiscard]] Colour difference_at(const Raster& picture, int32_t x, int32_t y,
                                   int32_t inset = 16) {
  return colour_at(picture, kDifference, x, y, inset);
}

TEST(StabilityPicture, TellsMissingExtraAndWrongApart) {
  const Raster picture = stability_picture(painter(), stability::reference(scene()));
  const Colour extra = difference_at(picture, 0, 0), missing = difference_at(picture, 5, 0);
  EXPECT_GT(extra.green, extra.blue);
  EXPECT_GT(missing.blue, missing.green);
  EXPECT_EQ(difference_at(picture, 3, 3), missing);
  const Colour right = difference_at(picture, 1, 0);
  EXPECT_LT(right.red + right.green + right.blue, 120);
}

TEST(StabilityPicture, IsBrighterWhereATexelIsFurtherOff) {
  const Raster picture = stability_picture(painter(), stability::reference(scene()));
  const Colour one = difference_at(picture, 2, 0), eight = difference_at(picture, 3, 0),
               fifteen = difference_at(picture, 4, 0);
  EXPECT_EQ(one.green, 0);
  EXPECT_GT(one.red, 100);
  EXPECT_GT(eight.red, one.red);
  EXPECT_GT(eight.green, one.green);
  EXPECT_GT(fifteen.green, eight.green);
}

TEST(StabilityPicture, FramesTheWorstPixel) {
  const Raster picture = stability_picture(painter(), stability::reference(scene()));
  EXPECT_EQ(difference_at(picture, 4, 0, 0), (Colour{255, 255, 255}));
  EXPECT_NE(difference_at(picture, 3, 0, 0), (Colour{255, 255, 255}));
}

TEST(StabilityPicture, StacksWhatIsWideAndEnlargesWhatIsTall) {
  spec::Case c = scene();
  c.target_width_px = 4096;
  c.target_height_px = 2;
  const Raster wide = stability_picture(painter(), stability::reference(c));
  EXPECT_EQ(wide.width_px, 96 * 12 + 2 * kGap_px);
  EXPECT_EQ(wide.height_px, 3 * (kCaption_px + 2 * 12 + kGap_px) + kGap_px);
  c.target_width_px = 2;
  c.target_height_px = 4096;
  const stability::Contender blank{"blank",
                                   "",
                                   stability::Promise::kNothing,
                                   SELVAGE_PROFILE_EXACT,
                                   false,
                                   {"blank", [](auto...) -> selvage_status { return SELVAGE_OK; }}};
  const Raster tall = stability_picture(blank, stability::reference(c));
  EXPECT_EQ(tall.width_px, 3 * (10 * 12 + kGap_px) + kGap_px) << "as wide as its captions";
  EXPECT_EQ(tall.height_px, kCaption_px + 32 * 12 + 2 * kGap_px);
}

}  // namespace
}  // namespace selvage::cli::test
