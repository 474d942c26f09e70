#include "cli/bitmap_font.h"

#include <algorithm>

namespace selvage::cli {
namespace {

inline constexpr int32_t kRows = 7, kColumns = 5;

// Glyphs side by side, six columns each; the sixth is blank.
struct Band {
  std::string_view characters;
  std::string_view rows[kRows];
};

// clang-format off
constexpr Band kBands[] = {
  {"ABCDEFGHIJKL",
   {" ###  ####   #### ####  ##### #####  #### #   #  ###    ### #   # #     ",
    "#   # #   # #     #   # #     #     #     #   #   #      #  #  #  #     ",
    "#   # #   # #     #   # #     #     #     #   #   #      #  # #   #     ",
    "##### ####  #     #   # ####  ####  #  ## #####   #      #  ##    #     ",
    "#   # #   # #     #   # #     #     #   # #   #   #      #  # #   #     ",
    "#   # #   # #     #   # #     #     #   # #   #   #   #  #  #  #  #     ",
    "#   # ####   #### ####  ##### #      #### #   #  ###   ##   #   # ##### "}},
  {"MNOPQRSTUVWX",
   {"#   # #   #  ###  ####   ###  ####   #### ##### #   # #   # #   # #   # ",
    "## ## ##  # #   # #   # #   # #   # #       #   #   # #   # #   # #   # ",
    "# # # # # # #   # #   # #   # #   # #       #   #   # #   # #   #  # #  ",
    "# # # #  ## #   # ####  #   # ####   ###    #   #   # #   # # # #   #   ",
    "#   # #   # #   # #     # # # # #       #   #   #   #  # #  # # #  # #  ",
    "#   # #   # #   # #     #  #  #  #      #   #   #   #  # #  ## ## #   # ",
    "#   # #   #  ###  #      ## # #   # ####    #    ###    #   #   # #   # "}},
  {"YZ0123456789",
   {"#   # #####  ###    #    ###   ###     #  #####  ###  #####  ###   ###  ",
    "#   #     # #   #  ##   #   # #   #   ##  #     #         # #   # #   # ",
    " # #     #  #  ##   #       #     #  # #  ####  #        #  #   # #   # ",
    "  #     #   # # #   #      #    ##  #  #      # ####     #   ###   #### ",
    "  #    #    ##  #   #     #       # #####     # #   #   #   #   #     # ",
    "  #   #     #   #   #    #    #   #    #  #   # #   #   #   #   #     # ",
    "  #   #####  ###   ###  #####  ###     #   ###   ###    #    ###   ###  "}},
  {".,:+-/%()=' ",
   {"                                #   ##  #   #    #          #           ",
    "                                #   ## #   #      #         #           ",
    "             ##    #           #      #   #        #  ####  #           ",
    "                   #          #       #   #        #                    ",
    "       ##        #####  ###   #      #    #        #  ####              ",
    " ##     #    ##    #         #      # ##  #        #                    ",
    " ##    #     ##    #         #     #  ##   #      #                     "}},
};
// clang-format on

static_assert(std::ranges::all_of(kBands, [](const Band& band) {
  return std::ranges::all_of(band.rows, [&](std::string_view row) {
    return row.size() == band.characters.size() * kGlyphWidth_dots;
  });
}));

[[nodiscard]] char capital(char character) {
  return character >= 'a' && character <= 'z' ? static_cast<char>(character - 'a' + 'A')
                                              : character;
}

[[nodiscard]] bool is_set(char character, int32_t column, int32_t row) {
  for (const Band& band : kBands) {
    const size_t at = band.characters.find(capital(character));
    if (at == std::string_view::npos) continue;
    return band.rows[row][at * kGlyphWidth_dots + static_cast<size_t>(column)] == '#';
  }
  return column == 0 || column == kColumns - 1 || row == 0 || row == kRows - 1;
}

// The part of the rectangle within the picture.
[[nodiscard]] selvage_rect within(const Raster& picture, int32_t left_px, int32_t top_px,
                                  int32_t width_px, int32_t height_px) {
  return {std::max(left_px, 0), std::max(top_px, 0), std::min(left_px + width_px, picture.width_px),
          std::min(top_px + height_px, picture.height_px)};
}

void fill(Raster& picture, const selvage_rect& area, const Colour& colour) {
  for (int32_t y = area.top; y < area.bottom; ++y) {
    for (int32_t x = area.left; x < area.right; ++x) picture.set(x, y, colour);
  }
}

}  // namespace

void draw_text(Raster& picture, int32_t left_px, int32_t top_px, int32_t dot_px,
               std::string_view text, const Colour& colour) {
  for (const char character : text) {
    if (left_px >= picture.width_px) return;
    for (int32_t row = 0; row < kRows; ++row) {
      for (int32_t column = 0; column < kColumns; ++column) {
        if (!is_set(character, column, row)) continue;
        fill(
            picture,
            within(picture, left_px + column * dot_px, top_px + (row + 1) * dot_px, dot_px, dot_px),
            colour);
      }
    }
    left_px += kGlyphWidth_dots * dot_px;
  }
}

void shade(Raster& picture, int32_t left_px, int32_t top_px, int32_t width_px, int32_t height_px) {
  const selvage_rect area = within(picture, left_px, top_px, width_px, height_px);
  for (int32_t y = area.top; y < area.bottom; ++y) {
    for (int32_t x = area.left; x < area.right; ++x) {
      Colour colour = picture.at(x, y);
      for (uint8_t* channel : {&colour.red, &colour.green, &colour.blue}) *channel /= 2;
      picture.set(x, y, colour);
    }
  }
}

}  // namespace selvage::cli
