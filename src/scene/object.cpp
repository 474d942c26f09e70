#include "scene/object.h"

#include <cmath>
#include <numbers>

namespace selvage::scene {
namespace {

inline constexpr double kStraight = 1e-9;  // of the product of two sides' lengths

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

bool is_convex(const Object& object, const Face& face) {
  const Vector3 outside = normal(object, face);
  const bool flat = outside.isZero(0);  // all on a line, or as much turned left as right
  double turned = 0;
  for (size_t i = 0; i < face.corners.size(); ++i) {
    const Vector3 before = vertex(object, face, i + 1) - vertex(object, face, i);
    const Vector3 after = vertex(object, face, i + 2) - vertex(object, face, i + 1);
    const double straight = kStraight * before.norm() * after.norm();
    if (flat && before.cross(after).norm() > straight) return false;
    const double sine = before.cross(after).dot(outside);
    if (sine < -straight) return false;
    turned += std::atan2(sine, before.dot(after));
  }
  return turned < 3 * std::numbers::pi;  // once around, not twice as a star does
}

}  // namespace selvage::scene
