#include "scene/lighting.h"

#include <algorithm>
#include <cmath>

namespace selvage::scene {
namespace {

[[nodiscard]] uint8_t step(double level) {
  return static_cast<uint8_t>(std::floor(255 * std::clamp(level, 0.0, 1.0) + 0.5));
}

}  // namespace

Light reflected(const Lighting& lighting, Shading shading, const Vector3& normal) {
  if (shading == Shading::kFlat) return {};
  Vector3 level = lighting.ambient;
  if (shading == Shading::kDiffuse) {
    for (const Lamp& lamp : lighting.lamps) {
      level += std::max(0.0, normal.dot(lamp.towards.stableNormalized())) * lamp.level;
    }
  }
  return {step(level.x()), step(level.y()), step(level.z())};
}

}  // namespace selvage::scene
