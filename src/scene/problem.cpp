#include <cmath>

#include "scene/look.h"

namespace selvage::scene {
namespace {

inline constexpr double kFarthest = 1e9;  // of vertices, times their object's scale

[[nodiscard]] bool is_finite(const Vector3& vector) { return vector.allFinite(); }

[[nodiscard]] std::string problem_of(const Camera& camera) {
  const Vector3 forward = camera.target - camera.position;
  if (!is_finite(camera.position) || !is_finite(forward) || !is_finite(camera.up)) {
    return "camera: position, target and up must be finite";
  }
  if (!(forward.cross(camera.up).norm() > 1e-9 * forward.norm() * camera.up.norm())) {
    return "camera: target must not be where the camera is, nor up along the view";
  }
  if (!(camera.view_deg > 0 && camera.view_deg < 180)) {
    return "camera: view_deg must be between 0 and 180";
  }
  if (!(camera.nearest_w > 0 && camera.farthest_w > camera.nearest_w &&
        camera.farthest_w <= kMostDepthRatio * camera.nearest_w)) {
    return "camera: 0 < nearest < farthest <= 1048576 nearest is needed";
  }
  return "";
}

[[nodiscard]] std::string problem_of(const Motion& motion) {
  if (!is_finite(motion.position) || !is_finite(motion.velocity) ||
      !std::isfinite(motion.angle_deg) || !std::isfinite(motion.spin_deg)) {
    return "its motion must be finite";
  }
  if (!is_finite(motion.axis) || !(motion.axis.stableNorm() > 0))
    return "its axis needs a direction";
  if (!std::isfinite(motion.scale) || !(motion.scale > 0)) return "its scale must be above 0";
  return "";
}

[[nodiscard]] std::string problem_of(const Scene& scene, const Object& object, const Face& face) {
  if (face.corners.size() < 3) return "has fewer than 3 corners";
  for (const Corner& corner : face.corners) {
    if (corner.vertex >= object.vertices.size()) return "has a corner at no vertex";
    if (!is_texture_place(corner.texture_texel)) {
      return "has texture coordinates beyond 32767 texels";
    }
  }
  if (face.material >= object.materials.size()) return "has no material";
  const std::optional<size_t>& texture = object.materials[face.material].texture;
  if (texture && *texture >= scene.textures.size()) return "has no texture";
  if (!is_convex(object, face)) return "is not convex; cut it into convex faces";
  return "";
}

}  // namespace

bool is_texture_place(const Vector2& texel) {
  return std::abs(texel.x()) <= kMostTexel && std::abs(texel.y()) <= kMostTexel;
}

std::string problem(const Scene& scene) {
  if (const std::string camera = problem_of(scene.camera); !camera.empty()) return camera;
  for (const Object& object : scene.objects) {
    const std::string motion = problem_of(object.motion);
    if (!motion.empty()) return "object '" + object.name + "': " + motion;
    for (const Vector3& vertex : object.vertices) {
      if (!(vertex.norm() * object.motion.scale <= kFarthest)) {
        return "object '" + object.name + "': a vertex is farther than 1000000000 from its origin";
      }
    }
    for (size_t i = 0; i < object.faces.size(); ++i) {
      const std::string face = problem_of(scene, object, object.faces[i]);
      if (!face.empty()) {
        return "object '" + object.name + "': face " + std::to_string(i + 1) + " " + face;
      }
    }
  }
  for (const Lamp& lamp : scene.lighting.lamps) {
    if (!is_finite(lamp.towards) || !(lamp.towards.stableNorm() > 0))
      return "a lamp needs a direction";
  }
  return "";
}

}  // namespace selvage::scene
