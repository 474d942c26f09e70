#include "scene/object.h"

namespace selvage::scene {

const Vector3& vertex_at(const Object& object, const Face& face, size_t corner) {
  return object.vertices[face.corners[corner % face.corners.size()].vertex];
}

Vector3 normal(const Object& object, const Face& face) {
  const Vector3& origin = vertex_at(object, face, 0);
  Vector3 doubled_area = Vector3::Zero();
  for (size_t i = 1; i + 1 < face.corners.size(); ++i) {
    doubled_area +=
        (vertex_at(object, face, i) - origin).cross(vertex_at(object, face, i + 1) - origin);
  }
  const double length = doubled_area.norm();
  if (!(length > 0)) return Vector3::Zero();
  return doubled_area / length;
}

}  // namespace selvage::scene
