#include "scene/object.h"

namespace selvage::scene {
namespace {

[[nodiscard]] const Vector3& vertex(const Object& object, const Face& face, size_t corner) {
  return object.vertices[face.corners[corner % face.corners.size()].vertex];
}

}  // namespace

Vector3 normal(const Object& object, const Face& face) {
  const Vector3& origin = vertex(object, face, 0);
  Vector3 doubled_area = Vector3::Zero();
  for (size_t i = 1; i + 1 < face.corners.size(); ++i) {
    doubled_area += (vertex(object, face, i) - origin).cross(vertex(object, face, i + 1) - origin);
  }
  const double length = doubled_area.norm();
  if (!(length > 0)) return Vector3::Zero();
  return doubled_area / length;
}

}  // namespace selvage::scene
