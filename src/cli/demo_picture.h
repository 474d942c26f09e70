// The picture of a demo's state: a function of the scene, the state and the size alone.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "cli/demo_state.h"
#include "cli/raster.h"
#include "scene/draw.h"

namespace selvage::cli {

struct DemoPicture {
  Raster raster;  // text and all; opaque
  size_t faces = 0;
  int64_t differing_px = 0;  // from the exact picture; counted where the difference is shown
};

// The difference is that of each channel, four times as bright, from the picture without any
// tolerance through the same filter, which for the historic mappers is nearest.
[[nodiscard]] DemoPicture demo_picture(const scene::Scene& scene, const DemoState& state,
                                       scene::Size size);

// The same of a scene that is posed already; the paints are its own, and may be of earlier poses.
[[nodiscard]] DemoPicture posed_picture(const scene::Scene& now, const DemoState& state,
                                        scene::Size size, scene::Paints& paints);

// "214 faces", and where the difference is shown "214 faces, 1034 px differ".
[[nodiscard]] std::string demo_counts(const DemoState& state, const DemoPicture& picture);

}  // namespace selvage::cli
