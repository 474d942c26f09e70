// Clipping in homogeneous coordinates, before anything is divided by w.
//
// Along a side of a face, screen place and texture are both linear, so a cut through the side cuts
// the texture at the same ratio: what is left of the face shows what it showed before.
#pragma once

#include <span>
#include <vector>

#include "scene/camera.h"
#include "scene/vectors.h"

namespace selvage::scene {

struct PlacedCorner {
  Vector3 place;  // (x w, y w, w)
  Vector2 texture_texel;
};
using Outline = std::vector<PlacedCorner>;

// Keeps what has normal . place + offset >= 0.
struct ClipPlane {
  Vector3 normal;
  double offset = 0;

  [[nodiscard]] double height(const Vector3& place) const { return normal.dot(place) + offset; }
};

// Sides x >= x_px and so on, as they are on the screen, for w > 0.
[[nodiscard]] inline ClipPlane right_of(double x_px) { return {{1, 0, -x_px}, 0}; }
[[nodiscard]] inline ClipPlane left_of(double x_px) { return {{-1, 0, x_px}, 0}; }
[[nodiscard]] inline ClipPlane below(double y_px) { return {{0, 1, -y_px}, 0}; }
[[nodiscard]] inline ClipPlane above(double y_px) { return {{0, -1, y_px}, 0}; }
[[nodiscard]] inline ClipPlane beyond(double w) { return {{0, 0, 1}, -w}; }
[[nodiscard]] inline ClipPlane within(double w) { return {{0, 0, -1}, w}; }

// Half of what the mapper takes: places within are never refused, whatever their rounding.
inline constexpr double kGuard_px = 16384;
inline constexpr int kMostSide_px = 16384;  // of a picture, so that it lies in the guard band

// Nearest and farthest w, then the guard band's four sides. The order matters: after the first, w
// is positive.
[[nodiscard]] std::vector<ClipPlane> clip_planes(const Camera& camera);

// What is left of a convex outline: convex, of at most one corner more a plane; fewer than three
// corners mean nothing. A cut through a side is computed from its inner end to its outer one,
// whichever comes first: two faces that share the side get the same corner, to the bit.
void clip(Outline& outline, std::span<const ClipPlane> planes);

}  // namespace selvage::scene
