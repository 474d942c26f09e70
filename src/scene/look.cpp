#include "scene/look.h"

#include <algorithm>
#include <limits>

#include "scene/frustum.h"

namespace selvage::scene {
namespace {

// A face on its way: clipped, not yet snapped.
struct Candidate {
  size_t object, face;
  Outline outline;
  Vector3 normal;  // in the world
};

[[nodiscard]] Outline outline_of(const Face& face, const std::vector<Vector3>& places) {
  Outline outline;
  for (const Corner& corner : face.corners) {
    outline.push_back({places[corner.vertex], corner.texture_texel});
  }
  return outline;
}

// Of one object, all faces of which something is left.
void add_candidates(const Scene& scene, size_t index, double time_s, Size size, Counts& counts,
                    std::vector<Candidate>& candidates) {
  const Object& object = scene.objects[index];
  const Placement to_world = placed(object.motion, time_s);
  const Placement to_eye = world_to_eye(scene.camera) * to_world;
  const Sphere sphere = sphere_around(object);
  ++counts.objects;
  if (!may_be_seen({to_eye * sphere.centre, sphere.radius * object.motion.scale}, scene.camera,
                   size)) {
    ++counts.objects_rejected;
    counts.faces_rejected += object.faces.size();
    return;
  }
  const Matrix3 to_place = eye_to_place(scene.camera, size);
  std::vector<Vector3> places;
  for (const Vector3& vertex : object.vertices) places.push_back(to_place * (to_eye * vertex));
  const std::vector<ClipPlane> planes = clip_planes(scene.camera);
  for (size_t i = 0; i < object.faces.size(); ++i) {
    Outline outline = outline_of(object.faces[i], places);
    clip(outline, planes);
    ++counts.faces;
    if (outline.size() < 3) {
      ++counts.clipped_away;
      continue;
    }
    const Vector3 turned = to_world.linear() * normal(object, object.faces[i]);
    candidates.push_back({index, i, std::move(outline), turned.normalized()});
  }
}

[[nodiscard]] double least_w(const std::vector<Candidate>& candidates) {
  double least = std::numeric_limits<double>::infinity();
  for (const Candidate& candidate : candidates) {
    for (const PlacedCorner& corner : candidate.outline) {
      least = std::min(least, corner.place.z());
    }
  }
  return least;
}

[[nodiscard]] double mean_w(const Outline& outline) {
  double sum = 0;
  for (const PlacedCorner& corner : outline) sum += corner.place.z();
  return sum / static_cast<double>(outline.size());
}

[[nodiscard]] Paint paint(const Scene& scene, const Candidate& candidate, bool from_behind) {
  const Object& object = scene.objects[candidate.object];
  const Material& material = object.materials[object.faces[candidate.face].material];
  const Vector3 normal = from_behind ? Vector3(-candidate.normal) : candidate.normal;
  const Light light = reflected(scene.lighting, material.shading, normal);
  return {material.texture, light, lit(material.colour, light)};
}

[[nodiscard]] bool is_in_picture(const std::vector<selvage_vertex>& vertices, Size size) {
  const auto [left, right] = std::minmax_element(
      vertices.begin(), vertices.end(), [](const auto& a, const auto& b) { return a.x < b.x; });
  const auto [top, bottom] = std::minmax_element(
      vertices.begin(), vertices.end(), [](const auto& a, const auto& b) { return a.y < b.y; });
  return left->x < size.width_px * SELVAGE_SUBPIXELS && right->x > 0 &&
         top->y < size.height_px * SELVAGE_SUBPIXELS && bottom->y > 0;
}

// Triangles are y-monotone whatever their corners are rounded to; those of a fan tile the face, but
// for slivers of a grid step.
void add_face(ScreenFace face, std::vector<ScreenFace>& faces) {
  if (is_y_monotone(face.vertices)) {
    faces.push_back(std::move(face));
    return;
  }
  for (size_t i = 1; i + 1 < face.vertices.size(); ++i) {
    ScreenFace triangle = face;
    triangle.vertices = {face.vertices[0], face.vertices[i], face.vertices[i + 1]};
    faces.push_back(std::move(triangle));
  }
}

}  // namespace

View look(const Scene& scene, double time_s, Size size) {
  View view;
  std::vector<Candidate> candidates;
  for (size_t i = 0; i < scene.objects.size(); ++i) {
    add_candidates(scene, i, time_s, size, view.counts, candidates);
  }
  const double w_near = least_w(candidates);  // one for all: shared sides and depths agree
  for (const Candidate& candidate : candidates) {
    ScreenFace face{candidate.object, candidate.face, {}, mean_w(candidate.outline), {}};
    const selvage_status status = snap(candidate.outline, w_near, face.vertices);
    if (status != SELVAGE_OK) {
      ++view.counts.refused;
      continue;
    }
    const int64_t area = doubled_area_seen(face.vertices);
    if (area == 0) {
      ++view.counts.edge_on;
    } else if (area < 0 && !scene.objects[candidate.object].two_sided) {
      ++view.counts.backs;
    } else if (!is_in_picture(face.vertices, size)) {
      ++view.counts.off_screen;
    } else {
      ++view.counts.seen;
      face.paint = paint(scene, candidate, area < 0);
      add_face(std::move(face), view.faces);
    }
  }
  return view;
}

}  // namespace selvage::scene
