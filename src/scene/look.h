// The pipeline: object -> world -> eye -> place -> clip -> screen.
#pragma once

#include <cstddef>
#include <vector>

#include "scene/scene.h"
#include "scene/screen_face.h"
#include "scene/vectors.h"

namespace selvage::scene {

// What became of everything in the scene.
struct Counts {
  size_t objects = 0, objects_rejected = 0;
  size_t faces_rejected = 0;  // with their objects
  size_t faces = 0;           // of objects that were not rejected; each is one of the following
  size_t clipped_away = 0, backs = 0, off_screen = 0, seen = 0;
  size_t edge_on = 0;  // without area on the grid
  size_t refused = 0;  // beyond the mapper's grid; none of a sound scene
};

struct View {
  std::vector<ScreenFace> faces;  // objects in order, faces in order; some in several triangles
  Counts counts;
};

// What is towards the eye and in the picture at that time. The scene has no problem (problem.h).
[[nodiscard]] View look(const Scene& scene, double time_s, Size size);

}  // namespace selvage::scene
