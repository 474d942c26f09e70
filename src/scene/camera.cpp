#include "scene/camera.h"

#include <cmath>
#include <numbers>

namespace selvage::scene {

Placement world_to_eye(const Camera& camera) {
  const Vector3 forward = (camera.target - camera.position).stableNormalized();
  const Vector3 right = forward.cross(camera.up.stableNormalized()).normalized();
  const Vector3 down = forward.cross(right);
  Matrix3 turn;
  turn.row(0) = right;
  turn.row(1) = down;
  turn.row(2) = forward;
  Placement to_eye = Placement::Identity();
  to_eye.linear() = turn;
  to_eye.translation() = -(turn * camera.position);
  return to_eye;
}

Matrix3 eye_to_place(const Camera& camera, Size size) {
  const double focus_px =
      size.height_px / 2.0 / std::tan(camera.view_deg * (std::numbers::pi / 360));
  Matrix3 to_place;
  to_place << focus_px, 0, size.width_px / 2.0,  //
      0, focus_px, size.height_px / 2.0,         //
      0, 0, 1;
  return to_place;
}

}  // namespace selvage::scene
