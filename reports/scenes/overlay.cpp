#include "reports/scenes/overlay.h"

#include <algorithm>
#include <array>

#include "cli/bitmap_font.h"

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

// The colours that occur, and what they stand for, below the picture.
[[nodiscard]] cli::Raster with_key(const cli::Raster& picture,
                                   const std::array<bool, kChoices>& occur) {
  constexpr int32_t kDot_px = 2, kSide_px = kDot_px * cli::kGlyphHeight_dots, kGap_px = 6;
  constexpr int32_t kLine_px = kSide_px + kGap_px;
  constexpr cli::Colour kGround{16, 18, 24, 255}, kInk{236, 238, 242, 255};
  const auto lines = static_cast<int32_t>(std::ranges::count(occur, true));
  const int32_t key_px = lines == 0 ? 0 : lines * kLine_px + kGap_px;
  cli::Raster all = cli::filled(picture.width_px, picture.height_px + key_px, kGround);
  std::ranges::copy(picture.rgba, all.rgba.begin());
  int32_t top_px = picture.height_px + kGap_px;
  for (size_t i = 0; i < kChoices; ++i) {
    if (!occur[i]) continue;
    const ChoiceStyle& style = style_of(choice_number(i));
    for (int32_t y_px = top_px; y_px < top_px + kSide_px; ++y_px) {
      for (int32_t x_px = kGap_px; x_px < std::min(kGap_px + kSide_px, all.width_px); ++x_px) {
        all.set(x_px, y_px, style.colour);
      }
    }
    cli::draw_text(all, 2 * kGap_px + kSide_px, top_px, kDot_px, style.id, kInk);
    top_px += kLine_px;
  }
  return all;
}

}  // namespace

cli::Raster overlay(const cli::Raster& picture, const ExactView& exact, const RowChoices& choices) {
  cli::Raster shown = picture;
  std::array<bool, kChoices> occur{};
  for (int32_t y_px = 0; y_px < exact.size.height_px; ++y_px) {
    for (int32_t x_px = 0; x_px < exact.size.width_px; ++x_px) {
      const std::optional<size_t> face = exact.pixel(x_px, y_px).face;
      if (!face) continue;
      int32_t light = kLeastLight + (256 - kLeastLight) * luma(picture.at(x_px, y_px)) / 255;
      if (is_border(exact, x_px, y_px)) light = light * kBorder >> 8;
      const Choice choice = choices.at(*face, y_px).choice;
      occur[static_cast<size_t>(choice)] = true;
      const cli::Colour& colour = style_of(choice).colour;
      shown.set(x_px, y_px,
                {scaled(colour.red, light), scaled(colour.green, light), scaled(colour.blue, light),
                 255});
    }
  }
  return with_key(shown, occur);
}

}  // namespace selvage::reports
