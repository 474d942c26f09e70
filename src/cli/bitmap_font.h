// Text in a picture, in a font of 5 x 7 dots: capitals, digits and what signs are needed.
#pragma once

#include <cstdint>
#include <string_view>

#include "cli/raster.h"

namespace selvage::cli {

inline constexpr int32_t kGlyphWidth_dots = 6, kGlyphHeight_dots = 9;  // with the space around

// One line. Small letters are drawn as capitals, what the font has not as a blank box. A dot is a
// square of `dot_px`; what falls outside of the picture is left out.
void draw_text(Raster& picture, int32_t left_px, int32_t top_px, int32_t dot_px,
               std::string_view text, const Colour& colour);

// Halves the light in a rectangle, so that text can be read on it.
void shade(Raster& picture, int32_t left_px, int32_t top_px, int32_t width_px, int32_t height_px);

}  // namespace selvage::cli
