// Two drawings of one target to look at: drawn | expected | difference, enlarged, with captions.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>

#include "cli/raster.h"
#include "spec/picture.h"

namespace selvage::cli {

struct PictureComparison {
  spec::Case scene;      // whose coordinate texture both were drawn with, unless
  bool colours = false;  // the pixels are colours: RGBA8888
  spec::Picture drawn{}, expected{};
  int32_t x_px = -1, y_px = -1;  // the pixel to show and to frame; -1, -1: the first that differs

  // What a pixel that differs is painted with in the difference.
  std::function<Colour(const std::optional<uint32_t>& drawn,
                       const std::optional<uint32_t>& expected)>
      difference{};
};

// Whether there is a difference to be seen.
[[nodiscard]] inline bool differs(const PictureComparison& comparison) {
  return comparison.drawn.pixels != comparison.expected.pixels;
}

// Texel (s, t) is coloured by its place, red growing with s and green with t; a value that no texel
// has is magenta. Colours are shown as they are, without alpha. What was not drawn is a grey
// chequerboard of two squares a pixel each way. The difference is a dim copy of what was expected
// where nothing differs. A white frame marks the pixel to show. Of a large target only the
// surroundings of that pixel are shown; of one much wider than high, one panel below the other.
[[nodiscard]] Raster comparison_picture(const PictureComparison& comparison);

}  // namespace selvage::cli
