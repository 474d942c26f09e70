#include "reports/scenes/overlay.h"

namespace selvage::reports {
namespace {

// Of 256: the least share of a choice's colour that is shown, and what a border leaves of it.
inline constexpr int32_t kLeastLight = 176, kBorder = 130;

// The luma of ITU-R BT.601, 0 .. 255.
[[nodiscard]] int32_t luma(const cli::Colour& colour) {
  return (77 * colour.red + 150 * colour.green + 29 * colour.blue + 128) >> 8;
}

// The face to the right or below is another one.
[[nodiscard]] bool is_border(const ExactView& exact, int32_t x_px, int32_t y_px) {
  const auto other = [&](int32_t x, int32_t y) {
    return x < exact.size.width_px && y < exact.size.height_px &&
           exact.pixel(x, y).face != exact.pixel(x_px, y_px).face;
  };
  return other(x_px + 1, y_px) || other(x_px, y_px + 1);
}

[[nodiscard]] uint8_t scaled(uint8_t channel, int32_t light) {
  return static_cast<uint8_t>((channel * light + 128) >> 8);
}

}  // namespace

cli::Raster overlay(const cli::Raster& picture, const ExactView& exact, const RowChoices& choices) {
  cli::Raster shown = picture;
  for (int32_t y_px = 0; y_px < exact.size.height_px; ++y_px) {
    for (int32_t x_px = 0; x_px < exact.size.width_px; ++x_px) {
      const std::optional<size_t> face = exact.pixel(x_px, y_px).face;
      if (!face) continue;
      int32_t light = kLeastLight + (256 - kLeastLight) * luma(picture.at(x_px, y_px)) / 255;
      if (is_border(exact, x_px, y_px)) light = light * kBorder >> 8;
      const cli::Colour& colour = style_of(choices.at(*face, y_px).choice).colour;
      shown.set(x_px, y_px,
                {scaled(colour.red, light), scaled(colour.green, light), scaled(colour.blue, light),
                 255});
    }
  }
  return shown;
}

}  // namespace selvage::reports
