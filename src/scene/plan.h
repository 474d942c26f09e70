// Only what the scene needs: the cheapest mapping of a face that is within what rounding to the
// grid leaves of the tolerance.
//
// Cheapest first: affine for the whole face, which leaves q out; affine along each row, and
// segments between divisions (both the mapper's own choice within options.tolerance); a division a
// pixel. README.md derives the bounds.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "scene/scene.h"
#include "scene/screen_face.h"
#include "selvage.h"

namespace selvage::scene {

// What is asked of all faces.
struct Wish {
  double tolerance_texel = 0;
  std::optional<selvage_filter> filter;  // empty: nearest where magnified, area where minified
};

struct Plan {
  bool affine = false;        // drawn with all q equal
  selvage_options options{};  // for selvage_draw
  // Of u and v, from the map on the grid: what affine costs, or at most what the mapper may take.
  // Within the tolerance less rounding_bound_texel, or 0.
  double bound_texel = 0;
  // Of the map on the grid, from the true one. Nothing that is chosen here can lessen it, so it may
  // be above the tolerance.
  double rounding_bound_texel = 0;
  double depth_ratio = 1;  // the greatest q over the least
  double affine_bound_texel = 0;
  double texels_per_px = 0;  // not below the footprint of any pixel; 0 without a texture
};

[[nodiscard]] Plan plan(const Scene& scene, const ScreenFace& face, const Wish& wish);

// The vertices to draw the face with: its own, or with equal q.
[[nodiscard]] std::vector<selvage_vertex> vertices_to_draw(const ScreenFace& face,
                                                           const Plan& plan);

// How far u and v move where all q are taken as equal: (sqrt r - 1) / (sqrt r + 1) of their range,
// r the greatest q over the least.
[[nodiscard]] double affine_bound_texel(std::span<const selvage_vertex> vertices);

// How far rounding q, u and v to the grid may move u and v.
[[nodiscard]] double rounding_bound_texel(std::span<const selvage_vertex> vertices);

// Not below |du/dx| + |du/dy|, nor the same of v, anywhere on a y-monotone face. Infinite where it
// has no area.
[[nodiscard]] double texels_per_px_bound(std::span<const selvage_vertex> vertices);

}  // namespace selvage::scene
