// A scene's picture by a profile's conventions: the historic mappers as they can take a scene.
#pragma once

#include <cstddef>

#include "cli/bitmap.h"
#include "scene/draw.h"

namespace selvage::cli {

struct ProfileDrawing {
  Bitmap picture;  // RGBA8888
  size_t faces = 0;
};

// The exact profile draws the scene as it is. The others get each face on whole pixels, without
// depth and clockwise (spec/profiles.h), and the filter nearest. What hides what is decided on the
// same whole pixels, by the depths that the mapper does not get. No face is refused: rounding down
// keeps the order of the rows, so that a y-monotone outline stays one. Throws UserError where one
// is. The paints are the scene's: what they have kept from other frames need not be made again.
[[nodiscard]] ProfileDrawing draw_by_profile(const scene::Scene& scene, double time_s,
                                             scene::Size size, const scene::Wish& wish,
                                             selvage_profile profile, scene::Paints& paints);

// One frame by itself.
[[nodiscard]] ProfileDrawing draw_by_profile(const scene::Scene& scene, double time_s,
                                             scene::Size size, const scene::Wish& wish,
                                             selvage_profile profile);

}  // namespace selvage::cli
