#include "cli/picture_file.h"

#include "cli/png.h"
#include "sample_pictures.h"
#include "support.h"

namespace selvage::cli::test {
namespace {

using PictureFile = InDirectory;

[[nodiscard]] std::string picture_refusal(const std::string& name) {
  return error_of([&] { static_cast<void>(read_picture(name)); });
}

// By its bytes: the name may lie.
TEST_F(PictureFile, IsKnownByItsBytes) {
  const Raster raster = smooth_raster(12, 9);
  put("png.jpg", encode_png(raster));
  put("jpeg.png", encode_jpeg(raster, JpegKind::kColour));
  EXPECT_EQ(read_picture("png.jpg"), raster);
  EXPECT_EQ(read_picture("jpeg.png").width_px, 12);
}

TEST_F(PictureFile, IsNamedInEveryError) {
  put("empty.png", std::string());
  put("text.png", std::string("GIF89a..........."));
  const std::vector<uint8_t> png = encode_png(smooth_raster(12, 9));
  const std::vector<uint8_t> jpeg = encode_jpeg(smooth_raster(12, 9), JpegKind::kColour);
  put("cut.png", std::span(png).first(60));
  put("cut.jpg", std::span(jpeg).first(jpeg.size() - 20));
  EXPECT_EQ(picture_refusal("empty.png"),
            "'empty.png': the file is empty; a PNG or a JPEG picture is needed");
  EXPECT_EQ(picture_refusal("text.png"), "'text.png': neither a PNG nor a JPEG picture");
  EXPECT_EQ(picture_refusal("cut.png"), "'cut.png': the PNG is cut short: it has no end chunk");
  expect_contains(picture_refusal("cut.jpg"), "'cut.jpg': the JPEG is cut short or damaged: ");
  EXPECT_EQ(picture_refusal("none.png"), "cannot read 'none.png': No such file or directory");
}

}  // namespace
}  // namespace selvage::cli::test
