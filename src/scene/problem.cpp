#include "scene/problem.h"

#include <cmath>

#include "scene/face_shape.h"

namespace selvage::scene {
namespace {

[[nodiscard]] bool is_direction(const Vector3& vector) {
  return vector.allFinite() && !vector.isZero(0);
}

[[nodiscard]] bool is_level(const Vector3& level) {
  return (level.array().abs() <= kMostLevel).all();
}

[[nodiscard]] std::string problem_of(const Scene& scene, const Object& object, const Face& face,
                                     double rounding) {
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
  return shape_problem(object, face, rounding);
}

[[nodiscard]] std::string problem_of(const Scene& scene, const Object& object) {
  if (const auto motion = fault(object.motion)) return "its " + motion->key + " " + motion->what;
  for (const Vector3& vertex : object.vertices) {
    if (!is_near(vertex)) return "a vertex is farther than 1000000000 from its origin";
    if (!is_near(vertex * object.motion.scale)) {
      return "its scale puts a vertex farther than 1000000000 from its origin";
    }
  }
  const double rounding = corner_rounding(object);
  for (size_t i = 0; i < object.faces.size(); ++i) {
    const std::string face = problem_of(scene, object, object.faces[i], rounding);
    if (!face.empty()) return "face " + std::to_string(i + 1) + " " + face;
  }
  return "";
}

}  // namespace

std::optional<Fault> fault(const Camera& camera) {
  const std::string within = "must be within 1000000000 of the world's origin";
  if (!is_near(camera.position)) return Fault{"position", within};
  if (!is_near(camera.target)) return Fault{"target", within};
  const Vector3 forward = camera.target - camera.position;
  if (forward.isZero(0)) return Fault{"target", "must not be where the camera is"};
  if (!is_direction(camera.up)) return Fault{"up", "needs a direction"};
  const double sine = forward.stableNormalized().cross(camera.up.stableNormalized()).norm();
  if (!(sine > 1e-9)) return Fault{"up", "must not be along the view"};
  if (!(camera.view_deg > 0 && camera.view_deg < 180)) {
    return Fault{"view_deg", "must be between 0 and 180"};
  }
  if (!(camera.view_deg >= kLeastView_deg)) {
    return Fault{"view_deg", "must be at least 0.000000001"};
  }
  if (!(camera.nearest_w > 0)) return Fault{"nearest", "must be above 0"};
  if (!(camera.farthest_w > camera.nearest_w &&
        camera.farthest_w <= kMostDepthRatio * camera.nearest_w)) {
    return Fault{"farthest", "must be above nearest, and at most 1048576 times it"};
  }
  return std::nullopt;
}

std::optional<Fault> fault(const Motion& motion) {
  if (!is_near(motion.position)) {
    return Fault{"position", "must be within 1000000000 of the world's origin"};
  }
  if (!is_near(motion.velocity)) return Fault{"velocity", "must be at most 1000000000 a second"};
  const auto is_turn = [](double angle_deg) { return std::abs(angle_deg) <= kFarthest; };
  if (!is_turn(motion.angle_deg)) return Fault{"angle_deg", "must be within 1000000000 degrees"};
  if (!is_turn(motion.spin_deg)) {
    return Fault{"spin_deg", "must be at most 1000000000 degrees a second"};
  }
  if (!is_direction(motion.axis)) return Fault{"axis", "needs a direction"};
  if (!std::isfinite(motion.scale) || !(motion.scale > 0)) return Fault{"scale", "must be above 0"};
  return std::nullopt;
}

std::optional<Fault> fault(const Lamp& lamp) {
  if (!is_direction(lamp.towards)) return Fault{"towards", "needs a direction"};
  if (!is_level(lamp.level)) return Fault{"level", "must be within 1000000000"};
  return std::nullopt;
}

std::optional<Fault> fault(const Lighting& lighting) {
  if (!is_level(lighting.ambient)) return Fault{"ambient", "must be within 1000000000"};
  return std::nullopt;
}

bool is_near(const Vector3& place) { return place.stableNorm() <= kFarthest; }

bool is_texture_place(const Vector2& texel) {
  return std::abs(texel.x()) <= kMostTexel && std::abs(texel.y()) <= kMostTexel;
}

std::string problem(const Scene& scene) {
  if (const auto camera = fault(scene.camera)) return "camera: " + camera->key + " " + camera->what;
  for (const Object& object : scene.objects) {
    const std::string what = problem_of(scene, object);
    if (!what.empty()) return "object '" + object.name + "': " + what;
  }
  if (const auto light = fault(scene.lighting)) return light->key + " " + light->what;
  for (const Lamp& lamp : scene.lighting.lamps) {
    if (const auto wrong = fault(lamp)) return "a lamp's " + wrong->key + " " + wrong->what;
  }
  return "";
}

}  // namespace selvage::scene
