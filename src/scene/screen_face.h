// A face on the mapper's grid.
//
// Snapping rounds x and y to 1/256 px, u and v to 1/65536 texel and q = 2^24 w_near / w to a whole
// number; README.md derives how far that moves the picture.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "scene/clip.h"
#include "scene/colour.h"
#include "selvage.h"

namespace selvage::scene {

// The grid's units, for arithmetic in double.
inline constexpr double kSubpixels = SELVAGE_SUBPIXELS, kSubtexels = SELVAGE_SUBTEXELS;
[[nodiscard]] inline double to_px(int32_t fx8) { return fx8 / kSubpixels; }

// What a face is painted with: a texture in a light, or one colour, lit already.
struct Paint {
  std::optional<size_t> texture;
  Light light;
  Colour colour;
};

struct ScreenFace {
  size_t object = 0, face = 0;  // of the scene; and of the object
  std::vector<selvage_vertex> vertices;
  double mean_w = 0;  // of the corners
  Paint paint;
};

// The first error of selvage_snap, if any; none for what clip_planes left of a face of a sound
// scene.
[[nodiscard]] selvage_status snap(const Outline& outline, double w_near,
                                  std::vector<selvage_vertex>& vertices);

// Twice the area on the screen, positive where the vertices run anticlockwise as seen: the outside
// of a face is towards the eye.
[[nodiscard]] int64_t doubled_area_seen(std::span<const selvage_vertex> vertices);

// Every scan line crosses two edges or none. Outlines of convex faces are, but for those with
// corners on one line that rounding bent.
[[nodiscard]] bool is_y_monotone(std::span<const selvage_vertex> vertices);

// The bound on what rounding q does to u and v, in parts of their range over the face: half of
// rho / (1 - rho), where rho = 1 / (2 q_min - 1) is not below the relative error of any q; at most
// 1, as no mean leaves the range.
[[nodiscard]] double q_rounding_bound(std::span<const selvage_vertex> vertices);

}  // namespace selvage::scene
