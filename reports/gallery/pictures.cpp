#include "reports/gallery/pictures.h"

#include "cli/picture_file.h"

namespace selvage::reports {

namespace {

constexpr int32_t kCheckerSide_texel = 8;

cli::Raster make_checker() {
  cli::Raster checker = cli::filled(kCheckerSide_texel, kCheckerSide_texel, {240, 232, 214, 255});
  for (int32_t t = 0; t < kCheckerSide_texel; ++t) {
    for (int32_t s = t % 2; s < kCheckerSide_texel; s += 2) checker.set(s, t, {36, 78, 122, 255});
  }
  return checker;
}

}  // namespace

Pictures load_pictures(const std::filesystem::path& directory) {
  const auto load = [&](const char* name) { return cli::read_picture(directory / name); };
  return {load("earth.jpg"),   load("iss.png"), load("hubble.png"),
          load("shuttle.png"), make_checker(),  cli::filled(1, 1, {255, 196, 84, 255})};
}

cli::Raster halved(const cli::Raster& picture) {
  cli::Raster half = cli::filled(picture.width_px / 2, picture.height_px / 2, {});
  const auto mean = [](int a, int b, int c, int d) {
    return static_cast<uint8_t>((a + b + c + d + 2) >> 2);
  };
  for (int32_t y = 0; y < half.height_px; ++y) {
    for (int32_t x = 0; x < half.width_px; ++x) {
      const cli::Colour a = picture.at(2 * x, 2 * y), b = picture.at(2 * x + 1, 2 * y);
      const cli::Colour c = picture.at(2 * x, 2 * y + 1), d = picture.at(2 * x + 1, 2 * y + 1);
      half.set(x, y,
               {mean(a.red, b.red, c.red, d.red), mean(a.green, b.green, c.green, d.green),
                mean(a.blue, b.blue, c.blue, d.blue), mean(a.alpha, b.alpha, c.alpha, d.alpha)});
    }
  }
  return half;
}

}  // namespace selvage::reports
