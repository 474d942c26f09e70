#include "cli/jpeg.h"

#include <algorithm>
#include <cstdlib>

#include "sample_pictures.h"
#include "support.h"

namespace selvage::cli::test {
namespace {

using Bytes = std::vector<uint8_t>;

[[nodiscard]] std::string jpeg_refusal(std::span<const uint8_t> bytes) {
  return error_of([&] { static_cast<void>(decode_jpeg(bytes)); });
}

[[nodiscard]] int largest_difference(const Raster& a, const Raster& b) {
  int largest = 0;
  for (size_t i = 0; i < a.rgba.size(); ++i) {
    largest = std::max(largest, std::abs(int{a.rgba[i]} - int{b.rgba[i]}));
  }
  return largest;
}

TEST(Jpeg, IsReadAsItIsSeen) {
  const Raster raster = smooth_raster(50, 37);
  for (const JpegKind kind : {JpegKind::kColour, JpegKind::kProgressive}) {
    const Raster read = decode_jpeg(encode_jpeg(raster, kind));
    ASSERT_EQ(read.width_px, 50);
    ASSERT_EQ(read.height_px, 37);
    ASSERT_EQ(read.rgba.size(), raster.rgba.size());
    EXPECT_LE(largest_difference(read, raster), 8);  // of 255, at quality 95
  }
}

TEST(Jpeg, InGreyIsReadAsGreyAndOpaque) {
  const Raster read = decode_jpeg(encode_jpeg(smooth_raster(20, 20), JpegKind::kGrey));
  for (size_t i = 0; i < read.rgba.size(); i += 4) {
    ASSERT_EQ(read.rgba[i], read.rgba[i + 1]);
    ASSERT_EQ(read.rgba[i], read.rgba[i + 2]);
    ASSERT_EQ(read.rgba[i + 3], 255);
  }
}

TEST(Jpeg, InCmykIsRefused) {
  EXPECT_EQ(jpeg_refusal(encode_jpeg(smooth_raster(8, 8), JpegKind::kCmyk)),
            "the JPEG is in CMYK; a grey or an RGB one is needed");
}

TEST(Jpeg, CutShortIsRefusedAtEveryLength) {
  for (const JpegKind kind : {JpegKind::kColour, JpegKind::kGrey, JpegKind::kProgressive}) {
    const Bytes whole = encode_jpeg(smooth_raster(20, 12), kind);
    ASSERT_NO_THROW(static_cast<void>(decode_jpeg(whole)));
    for (size_t length = 0; length < whole.size(); ++length) {
      EXPECT_FALSE(jpeg_refusal(std::span(whole).first(length)).empty()) << length;
    }
  }
}

TEST(Jpeg, WithAChangedByteIsRefusedOrWhole) {
  const Bytes whole = encode_jpeg(smooth_raster(20, 12), JpegKind::kProgressive);
  size_t refused = 0;
  for (size_t at = 0; at < whole.size(); ++at) {
    for (const int value : {0x00, 0x01, 0x7f, 0xd9, 0xff}) {
      Bytes damaged = whole;
      damaged[at] = static_cast<uint8_t>(value);
      try {
        const Raster read = decode_jpeg(damaged, {4096, 1 << 22});
        EXPECT_EQ(read.rgba.size(), size_t{4} * static_cast<size_t>(read.width_px) *
                                        static_cast<size_t>(read.height_px));
      } catch (const UserError&) {
        ++refused;
      }
    }
  }
  EXPECT_GT(refused, whole.size() / 4);
}

TEST(Jpeg, ThatClaimsTooMuchIsRefusedByItsHeader) {
  const Bytes whole = encode_jpeg(smooth_raster(20, 12), JpegKind::kColour);
  expect_contains(jpeg_refusal(with_jpeg_size(whole, 65500, 65500)),
                  "65500 x 65500 px is not accepted");
  expect_contains(jpeg_refusal(with_jpeg_size(whole, 32768, 32768)), "not accepted");
  expect_contains(jpeg_refusal(with_jpeg_size(whole, 32769, 1)), "not accepted");
  EXPECT_FALSE(jpeg_refusal(with_jpeg_size(whole, 0, 12)).empty());
  EXPECT_FALSE(jpeg_refusal(with_jpeg_size(whole, 20, 0)).empty());
}

TEST(Jpeg, ThatClaimsMoreThanItHoldsIsRefused) {
  for (const JpegKind kind : {JpegKind::kColour, JpegKind::kProgressive}) {
    const Bytes whole = encode_jpeg(smooth_raster(20, 12), kind);
    expect_contains(jpeg_refusal(with_jpeg_size(whole, 4000, 3000)), "cut short or damaged");
  }
}

TEST(Jpeg, IsHeldAgainstTheGivenLimits) {
  const Bytes whole = encode_jpeg(smooth_raster(20, 12), JpegKind::kColour);
  EXPECT_NO_THROW(static_cast<void>(decode_jpeg(whole, {20, 240})));
  EXPECT_THROW(static_cast<void>(decode_jpeg(whole, {19, 240})), UserError);
  EXPECT_THROW(static_cast<void>(decode_jpeg(whole, {20, 239})), UserError);
}

}  // namespace
}  // namespace selvage::cli::test
