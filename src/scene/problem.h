// What keeps a scene from being drawn.
#pragma once

#include <optional>
#include <string>

#include "scene/scene.h"

namespace selvage::scene {

// Of a part of a scene. `key` is its name in scene files: "scale", "must be above 0".
struct Fault {
  std::string key, what;
};
[[nodiscard]] std::optional<Fault> fault(const Camera& camera);
[[nodiscard]] std::optional<Fault> fault(const Motion& motion);
[[nodiscard]] std::optional<Fault> fault(const Lamp& lamp);
[[nodiscard]] std::optional<Fault> fault(const Lighting& lighting);  // but its lamps

// Of all of it, and where; empty if nothing is wrong.
[[nodiscard]] std::string problem(const Scene& scene);

// Where cameras, objects and, from their object's origin, vertices may be; and what angles, and
// changes in a second, may be.
inline constexpr double kFarthest = 1e9;
[[nodiscard]] bool is_near(const Vector3& place);

// Of the angle of view: a picture's height over its tangent is finite.
inline constexpr double kLeastView_deg = 1e-9;

// Of light, below 0 or above: sums of such levels are finite.
inline constexpr double kMostLevel = 1e9;

// Texture coordinates that the mapper's grid holds: selvage_snap takes u and v in [-32768, 32768).
inline constexpr double kMostTexel = 32767;
[[nodiscard]] bool is_texture_place(const Vector2& texel);

}  // namespace selvage::scene
