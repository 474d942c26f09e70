// Whole objects that cannot be in the picture.
#pragma once

#include "scene/camera.h"
#include "scene/object.h"
#include "scene/vectors.h"

namespace selvage::scene {

struct Sphere {
  Vector3 centre;
  double radius;
};

// Around all of an object's vertices, in its own space: not the smallest, but near.
[[nodiscard]] Sphere sphere_around(const Object& object);

// False only if nothing of the sphere (in the eye's space) is in the picture. True for some spheres
// near the picture's corners that are not.
[[nodiscard]] bool may_be_seen(const Sphere& sphere, const Camera& camera, Size size);

}  // namespace selvage::scene
