// The spaces of a scene, and the vectors they are written in.
//
//   object, world   right-handed, any unit; outsides of faces show their corners anticlockwise
//   eye             x right, y down, z forward: z is w, the distance along the view axis
//   screen place    (x w, y w, w) with x, y in px: what is linear in space is linear here
//   screen          the mapper's grid (selvage_vertex)
#pragma once

#include <Eigen/Geometry>

namespace selvage::scene {

using Vector2 = Eigen::Vector2d;
using Vector3 = Eigen::Vector3d;
using Vector4 = Eigen::Vector4d;
using Matrix3 = Eigen::Matrix3d;
using Placement = Eigen::Affine3d;

struct Size {
  int width_px = 0, height_px = 0;
};

}  // namespace selvage::scene
