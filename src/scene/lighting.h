// How much light a face reflects.
#pragma once

#include <vector>

#include "scene/colour.h"
#include "scene/object.h"
#include "scene/vectors.h"

namespace selvage::scene {

// Far away: its light comes from one direction everywhere.
struct Lamp {
  Vector3 towards = Vector3::UnitZ();  // the lamp, in the world
  Vector3 level = Vector3::Ones();     // red, green, blue; 1 shows a facing face's full colour
};

struct Lighting {
  Vector3 ambient = Vector3::Ones();
  std::vector<Lamp> lamps;
};

// Of a face with this unit normal in the world: the ambient level and, for kDiffuse, each lamp's
// times the cosine of the angle it falls in at; at most 1, to the nearest of 255 steps.
[[nodiscard]] Light reflected(const Lighting& lighting, Shading shading, const Vector3& normal);

}  // namespace selvage::scene
