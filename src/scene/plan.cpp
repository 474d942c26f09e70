#include "scene/plan.h"

#include <algorithm>
#include <cmath>

#include "scene/tolerance.h"

namespace selvage::scene {
namespace {

inline constexpr double kSlack = 1 + 0x1p-40;  // holds all roundings in double of the bounds here

struct Range {
  double least, most;
};
[[nodiscard]] Range range(std::span<const selvage_vertex> vertices,
                          int32_t selvage_vertex::*field) {
  const auto [least, most] =
      std::minmax_element(vertices.begin(), vertices.end(),
                          [&](const auto& a, const auto& b) { return a.*field < b.*field; });
  return {static_cast<double>((*least).*field), static_cast<double>((*most).*field)};
}

[[nodiscard]] double depth_ratio(std::span<const selvage_vertex> vertices) {
  const Range q = range(vertices, &selvage_vertex::q);
  return q.most / q.least;
}

[[nodiscard]] double range_texel(std::span<const selvage_vertex> vertices) {
  const Range u = range(vertices, &selvage_vertex::u), v = range(vertices, &selvage_vertex::v);
  return std::max(u.most - u.least, v.most - v.least) / kSubtexels;
}

}  // namespace

double affine_bound_texel(std::span<const selvage_vertex> vertices) {
  const double root = std::sqrt(depth_ratio(vertices));
  return range_texel(vertices) * (root - 1) / (root + 1) * kSlack;
}

double rounding_bound_texel(std::span<const selvage_vertex> vertices) {
  const double half_step = 0.5 / kSubtexels;  // so far are u and v rounded
  const double range = range_texel(vertices) + 2 * half_step;
  return (half_step + range * q_rounding_bound(vertices)) * kSlack;
}

Plan plan(const Scene& scene, const ScreenFace& face, const Wish& wish) {
  Plan plan;
  plan.depth_ratio = depth_ratio(face.vertices);
  if (!face.paint.texture) {  // one colour: no map can be wrong
    plan.affine = true;
    return plan;
  }
  plan.affine_bound_texel = affine_bound_texel(face.vertices);
  plan.texels_per_px = texels_per_px_bound(face.vertices);
  const bool minified = plan.texels_per_px > 1;
  plan.options.filter =
      wish.filter.value_or(minified ? SELVAGE_FILTER_AREA : SELVAGE_FILTER_NEAREST);
  plan.options.address = scene.textures[*face.paint.texture].address;
  plan.rounding_bound_texel = rounding_bound_texel(face.vertices);
  const double spare_texel = std::max(0.0, wish.tolerance_texel - plan.rounding_bound_texel);
  plan.affine = plan.affine_bound_texel <= spare_texel;
  if (plan.affine) {
    plan.bound_texel = plan.affine_bound_texel;
  } else if (plan.options.filter == SELVAGE_FILTER_NEAREST) {
    const double tolerance = std::min(spare_texel, kMostTolerance_texel);
    plan.options.tolerance = static_cast<int32_t>(std::floor(tolerance * kSubtexels));
    plan.bound_texel = plan.options.tolerance / kSubtexels;
  }
  return plan;
}

std::vector<selvage_vertex> vertices_to_draw(const ScreenFace& face, const Plan& plan) {
  std::vector<selvage_vertex> vertices = face.vertices;
  if (plan.affine) {
    for (selvage_vertex& vertex : vertices) vertex.q = 1;
  }
  return vertices;
}

}  // namespace selvage::scene
