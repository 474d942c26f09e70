#include "scene/reach.h"

#include <algorithm>
#include <cmath>

namespace selvage::scene {
namespace {

struct Columns {  // or rows: [first, end)
  int32_t first, end;
};

// Of a texture so wide, those that numbers from `least` to `most` are addressed to.
[[nodiscard]] Columns addressed(double least, double most, int32_t width_texel,
                                selvage_address address) {
  const double width = width_texel, first = std::floor(least), last = std::floor(most);
  if (address == SELVAGE_ADDRESS_CLAMP) {
    return {static_cast<int32_t>(std::clamp(first, 0.0, width - 1)),
            static_cast<int32_t>(std::clamp(last, 0.0, width - 1)) + 1};
  }
  const double period = std::floor(first / width);
  if (!(std::floor(last / width) == period)) return {0, width_texel};
  return {static_cast<int32_t>(first - period * width),
          static_cast<int32_t>(last - period * width) + 1};
}

// How far beside (u, v) texels are read.
[[nodiscard]] double margin_texel(const ScreenFace& face, const Plan& plan) {
  switch (plan.options.filter) {
    case SELVAGE_FILTER_NEAREST:
      return plan.options.tolerance / kSubtexels;
    case SELVAGE_FILTER_AREA:
      // The box is rounded outward by less than a texel on either side.
      return texels_per_px_bound(vertices_to_draw(face, plan)) / 2 + 2;
    default:
      return 1;
  }
}

[[nodiscard]] Columns reach(const ScreenFace& face, int32_t selvage_vertex::*coordinate,
                            double margin_texel, int32_t width_texel, selvage_address address) {
  const auto [least, most] = std::minmax_element(
      face.vertices.begin(), face.vertices.end(),
      [&](const auto& a, const auto& b) { return a.*coordinate < b.*coordinate; });
  return addressed((*least).*coordinate / kSubtexels - margin_texel,
                   (*most).*coordinate / kSubtexels + margin_texel, width_texel, address);
}

}  // namespace

selvage_rect reach_texel(const TextureImage& image, const ScreenFace& face, const Plan& plan) {
  const double margin = margin_texel(face, plan);
  const Columns columns =
      reach(face, &selvage_vertex::u, margin, image.width_texel, plan.options.address);
  const Columns rows =
      reach(face, &selvage_vertex::v, margin, image.height_texel, plan.options.address);
  return {columns.first, rows.first, columns.end, rows.end};
}

}  // namespace selvage::scene
