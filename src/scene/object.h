// What stands in a scene: objects of convex faces, each in a space of its own.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "scene/colour.h"
#include "scene/motion.h"
#include "scene/vectors.h"

namespace selvage::scene {

enum class Shading {
  kFlat,     // the colour, or the texels, as they are
  kAmbient,  // times the ambient light
  kDiffuse   // times the ambient light and that of the lamps, by Lambert's cosine
};

struct Material {
  std::string name;
  Colour colour;
  Shading shading = Shading::kDiffuse;
  std::optional<size_t> texture;  // of the scene's; then `colour` is not looked at
};

struct Corner {
  size_t vertex = 0;
  Vector2 texture_texel = Vector2::Zero();
};

// Plane and convex, n >= 3 corners; seen from outside they run anticlockwise.
struct Face {
  std::vector<Corner> corners;
  size_t material = 0;
};

struct Object {
  std::string name;
  std::vector<Vector3> vertices;
  std::vector<Face> faces;
  std::vector<Material> materials;
  bool two_sided = false;  // no closed body: faces show their backs too
  Motion motion;
};

// Where the face's n-th corner stands; the corners are counted around, so that the first follows
// the last.
[[nodiscard]] const Vector3& vertex_at(const Object& object, const Face& face, size_t corner);

// The unit normal on the outside; zero where the corners lie on a line. (Newell's method: the
// components are the areas of the projections, so that no three corners are trusted alone.)
[[nodiscard]] Vector3 normal(const Object& object, const Face& face);

}  // namespace selvage::scene
