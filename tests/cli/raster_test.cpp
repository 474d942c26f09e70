#include "cli/raster.h"

#include "support.h"

namespace selvage::cli::test {
namespace {

TEST(Colour, HasThreeForms) {
  EXPECT_EQ(parse_colour("#1aF"), (Colour{0x11, 0xaa, 0xff, 255}));
  EXPECT_EQ(parse_colour("#203040"), (Colour{0x20, 0x30, 0x40, 255}));
  EXPECT_EQ(parse_colour("#fEdCbA80"), (Colour{0xfe, 0xdc, 0xba, 0x80}));
}

TEST(Colour, OfAnotherFormIsRefused) {
  for (const char* text : {"", "#", "#12", "#1234", "#12345", "#1234567", "#123456789", "203040",
                           "#20304g", "# 23", "#-12", "##203040", "red"}) {
    EXPECT_EQ(error_of([&] { static_cast<void>(parse_colour(text)); }),
              "'" + std::string(text) + "' is no colour; #rgb, #rrggbb or #rrggbbaa is");
  }
}

TEST(Size, IsLimitedBySideAndArea) {
  const auto refused = [](int64_t width_px, int64_t height_px, const SizeLimits& limits = {}) {
    try {
      check_size(width_px, height_px, limits);
      return false;
    } catch (const UserError&) {
      return true;
    }
  };
  EXPECT_FALSE(refused(1, 1));
  EXPECT_FALSE(refused(32768, 2048));  // 2^26
  EXPECT_FALSE(refused(2048, 32768));
  EXPECT_TRUE(refused(32768, 2049));
  EXPECT_TRUE(refused(32769, 1));
  EXPECT_TRUE(refused(1, 32769));
  EXPECT_TRUE(refused(0, 1));
  EXPECT_TRUE(refused(1, 0));
  EXPECT_TRUE(refused(-1, -1));
  EXPECT_TRUE(refused(INT64_MAX, INT64_MAX));
  EXPECT_TRUE(refused(11, 1, {10, 100}));
  EXPECT_FALSE(refused(10, 10, {10, 100}));
  EXPECT_TRUE(refused(10, 10, {10, 99}));
}

TEST(Size, ThatIsRefusedIsNamed) {
  EXPECT_EQ(error_of([] { check_size(40000, 2); }),
            "a picture of 40000 x 2 px is not accepted; 1 to 32768 px a side and at most 67108864 "
            "px in all are");
}

TEST(Raster, HoldsEachPixelInItsPlace) {
  Raster raster = filled(5, 3, {1, 2, 3, 4});
  raster.set(4, 1, {9, 8, 7, 6});
  for (int32_t y = 0; y < 3; ++y) {
    for (int32_t x = 0; x < 5; ++x) {
      EXPECT_EQ(raster.at(x, y), x == 4 && y == 1 ? (Colour{9, 8, 7, 6}) : (Colour{1, 2, 3, 4}));
    }
  }
  EXPECT_EQ(raster.rgba[4 * 9], 9);
}

}  // namespace
}  // namespace selvage::cli::test
