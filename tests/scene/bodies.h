// Convex bodies for tests.
#pragma once

#include <cmath>
#include <numbers>

#include "scene/object.h"
#include "scene/vectors.h"

namespace selvage::scene {

inline constexpr Size kBodiesTarget{96, 72};  // of small pictures of them

// A ball of plane faces: triangles around the poles, trapezoids between.
[[nodiscard]] inline Object ball(int meridians, int parallels) {
  Object object;
  object.name = "ball";
  object.materials.emplace_back();
  object.vertices.emplace_back(0, 1, 0);
  for (int p = 1; p < parallels; ++p) {
    for (int m = 0; m < meridians; ++m) {
      const double down = std::numbers::pi * p / parallels;
      const double around = 2 * std::numbers::pi * m / meridians;
      object.vertices.emplace_back(std::sin(down) * std::sin(around), std::cos(down),
                                   std::sin(down) * std::cos(around));
    }
  }
  object.vertices.emplace_back(0, -1, 0);
  const auto vertex = [&](int p, int m) {
    if (p == 0) return size_t{0};
    if (p == parallels) return object.vertices.size() - 1;
    return static_cast<size_t>(1 + (p - 1) * meridians + m % meridians);
  };
  for (int p = 0; p < parallels; ++p) {
    for (int m = 0; m < meridians; ++m) {
      Face face;
      face.corners.push_back({vertex(p, m), {0, 0}});
      face.corners.push_back({vertex(p + 1, m), {0, 64}});
      if (p + 1 < parallels) face.corners.push_back({vertex(p + 1, m + 1), {64, 64}});
      if (p > 0) face.corners.push_back({vertex(p, m + 1), {64, 0}});
      object.faces.push_back(face);
    }
  }
  return object;
}

[[nodiscard]] inline Object cube() {
  Object object;
  object.name = "cube";
  for (int i = 0; i < 8; ++i) {
    object.vertices.emplace_back(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1);
  }
  const size_t faces[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                              {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  for (const auto& corners : faces) {
    Face face;
    for (const size_t vertex : corners) face.corners.push_back({vertex, {0, 0}});
    object.faces.push_back(face);
  }
  object.materials.emplace_back();
  return object;
}

}  // namespace selvage::scene
