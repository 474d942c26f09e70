#include "scene/frustum.h"

#include <algorithm>

#include "scene/clip.h"

namespace selvage::scene {

Sphere sphere_around(const Object& object) {
  Eigen::AlignedBox3d box;
  for (const Vector3& vertex : object.vertices) box.extend(vertex);
  if (box.isEmpty()) return {Vector3::Zero(), 0};
  double radius = 0;
  for (const Vector3& vertex : object.vertices) {
    radius = std::max(radius, (vertex - box.center()).norm());
  }
  return {box.center(), radius};
}

bool may_be_seen(const Sphere& sphere, const Camera& camera, Size size) {
  const Matrix3 to_place = eye_to_place(camera, size);
  const ClipPlane planes[] = {beyond(camera.nearest_w),
                              within(camera.farthest_w),
                              right_of(0),
                              left_of(size.width_px),
                              below(0),
                              above(size.height_px)};
  for (const ClipPlane& plane : planes) {
    const Vector3 in_eye =
        to_place.transpose() * plane.normal;  // the same plane in the eye's space
    const double height = in_eye.dot(sphere.centre) + plane.offset;
    if (height < -sphere.radius * in_eye.norm()) return false;
  }
  return true;
}

}  // namespace selvage::scene
