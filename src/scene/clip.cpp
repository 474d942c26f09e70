#include "scene/clip.h"

#include <utility>

namespace selvage::scene {
namespace {

[[nodiscard]] PlacedCorner cut(const PlacedCorner& inner, const PlacedCorner& outer,
                               double inner_height, double outer_height) {
  const double part = inner_height / (inner_height - outer_height);
  return {inner.place + part * (outer.place - inner.place),
          inner.texture_texel + part * (outer.texture_texel - inner.texture_texel)};
}

// Sutherland and Hodgman, "Reentrant polygon clipping", 1974.
[[nodiscard]] Outline clipped(const Outline& outline, const ClipPlane& plane) {
  Outline kept;
  kept.reserve(outline.size() + 1);
  for (size_t i = 0; i < outline.size(); ++i) {
    const PlacedCorner& a = outline[i];
    const PlacedCorner& b = outline[(i + 1) % outline.size()];
    const double a_height = plane.height(a.place), b_height = plane.height(b.place);
    if (a_height >= 0) kept.push_back(a);
    if (a_height >= 0 && b_height < 0) kept.push_back(cut(a, b, a_height, b_height));
    if (a_height < 0 && b_height >= 0) kept.push_back(cut(b, a, b_height, a_height));
  }
  return kept;
}

[[nodiscard]] bool is_whole(const Outline& outline, const ClipPlane& plane) {
  for (const PlacedCorner& corner : outline) {
    if (!(plane.height(corner.place) >= 0)) return false;
  }
  return true;
}

}  // namespace

std::vector<ClipPlane> clip_planes(const Camera& camera) {
  return {beyond(camera.nearest_w), within(camera.farthest_w), right_of(-kGuard_px),
          left_of(kGuard_px),       below(-kGuard_px),         above(kGuard_px)};
}

void clip(Outline& outline, std::span<const ClipPlane> planes) {
  for (const ClipPlane& plane : planes) {
    if (!is_whole(outline, plane)) outline = clipped(outline, plane);
  }
}

}  // namespace selvage::scene
