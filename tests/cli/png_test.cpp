#include "cli/png.h"

#include <png.h>

#include "sample_pictures.h"
#include "support.h"

namespace selvage::cli::test {
namespace {

using Bytes = std::vector<uint8_t>;

[[nodiscard]] std::string png_refusal(std::span<const uint8_t> bytes) {
  return error_of([&] { static_cast<void>(decode_png(bytes)); });
}

TEST(Png, ComesBackAsItWas) {
  for (const auto& [width, height] : {std::pair{1, 1}, {1, 40}, {40, 1}, {31, 17}, {257, 64}}) {
    const Raster raster = sample_raster(width, height);
    EXPECT_EQ(decode_png(encode_png(raster)), raster);
  }
}

TEST(Png, OfEveryKindIsRead) {
  const PngKind kinds[] = {
      {PNG_COLOR_TYPE_GRAY, 1, false},       {PNG_COLOR_TYPE_GRAY, 2, true},
      {PNG_COLOR_TYPE_GRAY, 4, false},       {PNG_COLOR_TYPE_GRAY, 8, true},
      {PNG_COLOR_TYPE_GRAY, 16, false},      {PNG_COLOR_TYPE_PALETTE, 1, true},
      {PNG_COLOR_TYPE_PALETTE, 4, false},    {PNG_COLOR_TYPE_RGB, 8, true},
      {PNG_COLOR_TYPE_RGB, 16, false},       {PNG_COLOR_TYPE_GRAY_ALPHA, 8, false},
      {PNG_COLOR_TYPE_GRAY_ALPHA, 16, true}, {PNG_COLOR_TYPE_RGB_ALPHA, 8, true},
      {PNG_COLOR_TYPE_RGB_ALPHA, 16, false}};
  for (const PngKind& kind : kinds) {
    const Raster raster = decode_png(sample_png(kind));
    EXPECT_EQ(raster.width_px, 9);
    EXPECT_EQ(raster.height_px, 7);
    EXPECT_EQ(raster.rgba.size(), 9u * 7 * 4);
    EXPECT_NE(raster, filled(9, 7, raster.at(0, 0))) << "an even picture was read";
  }
}

// sample_png fills its rows with bytes 73 i + 5.
TEST(Png, OfDirectColoursIsReadByteForByte) {
  const Raster rgba = decode_png(sample_png({PNG_COLOR_TYPE_RGB_ALPHA, 8, true}));
  for (size_t i = 0; i < rgba.rgba.size(); ++i) {
    ASSERT_EQ(rgba.rgba[i], static_cast<uint8_t>(73 * i + 5));
  }
  const Raster rgb = decode_png(sample_png({PNG_COLOR_TYPE_RGB, 8, false}));
  EXPECT_EQ(rgb.at(1, 0), (Colour{224, 41, 114, 255}));
  const Raster deep = decode_png(sample_png({PNG_COLOR_TYPE_RGB, 16, false}));
  EXPECT_NEAR(deep.at(0, 0).red, 5, 1);  // 5 * 256 + 78 of 65535
}

TEST(Png, WithAPaletteIsReadThroughIt) {
  const Raster raster = decode_png(sample_png({PNG_COLOR_TYPE_PALETTE, 8, false}));
  EXPECT_EQ(raster.at(0, 0), (Colour{200, 210, 85, 250}));  // entry 5: 40 i, 255 - 9 i, 17 i
}

TEST(Png, CutShortIsRefusedAtEveryLength) {
  for (const Bytes& whole :
       {encode_png(sample_raster(7, 5)), sample_png({PNG_COLOR_TYPE_PALETTE, 4, true})}) {
    ASSERT_NO_THROW(static_cast<void>(decode_png(whole)));
    for (size_t length = 0; length < whole.size(); ++length) {
      EXPECT_FALSE(png_refusal(std::span(whole).first(length)).empty()) << length;
    }
  }
}

// A flipped bit is either found or harmless (in a chunk that is skipped); it never crashes.
TEST(Png, WithAFlippedBitIsRefusedOrOfItsSize) {
  const Bytes whole = encode_png(sample_raster(7, 5));
  size_t refused = 0;
  for (size_t bit = 0; bit < 8 * whole.size(); ++bit) {
    Bytes damaged = whole;
    damaged[bit / 8] = static_cast<uint8_t>(damaged[bit / 8] ^ 1 << bit % 8);
    try {
      const Raster raster = decode_png(damaged);
      EXPECT_EQ(raster.width_px, 7);
      EXPECT_EQ(raster.height_px, 5);
    } catch (const UserError&) {
      ++refused;
    }
  }
  EXPECT_GT(refused, 4 * whole.size());
}

TEST(Png, ThatClaimsTooMuchIsRefusedByItsHeader) {
  const Bytes whole = encode_png(sample_raster(7, 5));
  expect_contains(png_refusal(with_png_size(whole, 32769, 1)), "32769 x 1 px is not accepted");
  expect_contains(png_refusal(with_png_size(whole, 1, 32769)), "not accepted");
  expect_contains(png_refusal(with_png_size(whole, 32768, 32768)), "not accepted");
  expect_contains(png_refusal(with_png_size(whole, 32768, 2048)), "cannot hold 32768 x 2048 px");
  EXPECT_FALSE(png_refusal(with_png_size(whole, 0, 5)).empty());
  EXPECT_FALSE(png_refusal(with_png_size(whole, 0x7fffffff, 0x7fffffff)).empty());
  EXPECT_FALSE(png_refusal(with_png_size(whole, 0xffffffff, 0xffffffff)).empty());
}

TEST(Png, ThatClaimsMoreThanItHoldsIsRefused) {
  const Bytes whole = encode_png(sample_raster(7, 5));
  EXPECT_FALSE(png_refusal(with_png_size(whole, 8, 5)).empty());
  EXPECT_FALSE(png_refusal(with_png_size(whole, 7, 6)).empty());
}

TEST(Png, IsHeldAgainstTheGivenLimits) {
  const Bytes whole = encode_png(sample_raster(7, 5));
  EXPECT_NO_THROW(static_cast<void>(decode_png(whole, {7, 35})));
  EXPECT_THROW(static_cast<void>(decode_png(whole, {6, 35})), UserError);
  EXPECT_THROW(static_cast<void>(decode_png(whole, {7, 34})), UserError);
}

}  // namespace
}  // namespace selvage::cli::test
