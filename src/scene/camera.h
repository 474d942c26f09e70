// From the world to the eye, and from there to screen places.
#pragma once

#include "scene/vectors.h"

namespace selvage::scene {

struct Camera {
  Vector3 position{0, 0, 5};
  Vector3 target = Vector3::Zero();  // what is in the middle of the picture
  Vector3 up = Vector3::UnitY();     // not along the view
  double view_deg = 45;              // from the picture's upper to its lower edge
  double nearest_w = 0.125, farthest_w = 65536;
};

// 1 / w has 24 bits on the mapper's grid; this leaves four of them at the far end.
inline constexpr double kMostDepthRatio = 1 << 20;

[[nodiscard]] Placement world_to_eye(const Camera& camera);

// The middle of the picture is the view axis; pixels are squares.
[[nodiscard]] Matrix3 eye_to_place(const Camera& camera, Size size);

}  // namespace selvage::scene
