#include "cli/bitmap.h"

#include <cstdlib>
#include <cstring>

#include "sample_pictures.h"
#include "support.h"

namespace selvage::cli::test {
namespace {

TEST(Bitmap, InRgba8888KeepsEveryByte) {
  const Raster raster = sample_raster(13, 9);
  const Bitmap bitmap = to_bitmap(raster, SELVAGE_RGBA8888);
  EXPECT_EQ(bitmap.bytes, raster.rgba);
  EXPECT_EQ(to_raster(bitmap), raster);
}

TEST(Bitmap, InRgb565ComesBackAsItWas) {
  Bitmap bitmap{SELVAGE_RGB565, 256, 256, std::vector<uint8_t>(131072)};
  for (uint32_t i = 0; i < 65536; ++i) {
    const auto pixel = static_cast<uint16_t>(i);
    std::memcpy(bitmap.bytes.data() + 2 * i, &pixel, 2);
  }
  EXPECT_EQ(to_bitmap(to_raster(bitmap), SELVAGE_RGB565).bytes, bitmap.bytes);
}

// The chosen level is the one whose 8-bit value is nearest: no other level is nearer.
void expect_nearest(int level, int level_max, int value) {
  const auto distance = [&](int candidate) {
    return std::abs(candidate * 255 - value * level_max);  // times 255 x level_max
  };
  for (int other = 0; other <= level_max; ++other) {
    ASSERT_LE(distance(level), distance(other)) << value << " became " << level;
  }
}

TEST(Bitmap, InRgb565HasTheNearestLevels) {
  for (int value = 0; value < 256; ++value) {
    const auto level = static_cast<uint8_t>(value);
    const Bitmap bitmap = to_bitmap(filled(1, 1, {level, level, level}), SELVAGE_RGB565);
    uint16_t pixel = 0;
    std::memcpy(&pixel, bitmap.bytes.data(), 2);
    expect_nearest(pixel >> 11, 31, value);
    expect_nearest(pixel >> 5 & 63, 63, value);
    expect_nearest(pixel & 31, 31, value);
  }
}

TEST(Bitmap, InRgb565HasRedHighAndBlueLow) {
  uint16_t pixel = 0;
  std::memcpy(&pixel, to_bitmap(filled(1, 1, {255, 0, 0}), SELVAGE_RGB565).bytes.data(), 2);
  EXPECT_EQ(pixel, 0xf800);
  std::memcpy(&pixel, to_bitmap(filled(1, 1, {0, 0, 255}), SELVAGE_RGB565).bytes.data(), 2);
  EXPECT_EQ(pixel, 0x001f);
}

TEST(Bitmap, OfGreyKeepsGreys) {
  for (int value = 0; value < 256; ++value) {
    const auto level = static_cast<uint8_t>(value);
    const Raster grey = filled(1, 1, {level, level, level});
    EXPECT_EQ(to_raster(to_bitmap(grey, SELVAGE_INDEX8)), grey);
  }
}

TEST(Bitmap, OfGreyWeighsGreenMost) {
  EXPECT_EQ(to_bitmap(filled(1, 1, {255, 0, 0}), SELVAGE_INDEX8).bytes[0], 77);
  EXPECT_EQ(to_bitmap(filled(1, 1, {0, 255, 0}), SELVAGE_INDEX8).bytes[0], 149);
  EXPECT_EQ(to_bitmap(filled(1, 1, {0, 0, 255}), SELVAGE_INDEX8).bytes[0], 29);
}

TEST(Bitmap, IsAnImageTheMapperAccepts) {
  for (const selvage_format format : {SELVAGE_RGBA8888, SELVAGE_RGB565, SELVAGE_INDEX8}) {
    Bitmap target = to_bitmap(filled(6, 4, {}), format);
    const Bitmap source = to_bitmap(filled(3, 2, {255, 255, 255}), format);
    const selvage_vertex all[] = {
        {0, 0, 0, 0, 1}, {6 * 256, 0, 0, 0, 1}, {6 * 256, 4 * 256, 0, 0, 1}, {0, 4 * 256, 0, 0, 1}};
    const selvage_image image = target.image();
    const selvage_texture texture = source.texture();
    ASSERT_EQ(selvage_draw(&image, nullptr, all, 4, &texture, nullptr), SELVAGE_OK);
    EXPECT_EQ(to_raster(target), filled(6, 4, {255, 255, 255}));
  }
}

TEST(Format, HasAName) {
  for (const char* name : {"rgba8888", "rgb565", "index8"}) {
    EXPECT_EQ(format_name(parse_format(name)), name);
  }
  EXPECT_EQ(parse_format("grey8"), SELVAGE_INDEX8);
  EXPECT_EQ(error_of([] { static_cast<void>(parse_format("rgb888")); }),
            "'rgb888' is no format; rgba8888, rgb565 and index8 are");
}

}  // namespace
}  // namespace selvage::cli::test
