#include "mapper/draw.h"

#include <algorithm>
#include <optional>

#include "mapper/copy_row.h"
#include "mapper/edge.h"
#include "mapper/filter_draw.h"
#include "mapper/image.h"
#include "mapper/plane.h"
#include "mapper/row_kernel.h"
#include "mapper/span.h"

namespace selvage::mapper {
namespace {

// Texel centres on pixel centres, one for one: bilinear weights are 0 and 1, the box is one texel.
[[nodiscard]] bool is_copy(const Polygon& polygon, selvage_filter filter) {
  return polygon.untransformed && filter != SELVAGE_FILTER_FOUR;
}

}  // namespace

void draw(const selvage_image& target, const selvage_rect& visible, const Polygon& polygon,
          const selvage_texture& texture, selvage_address address, selvage_filter filter) {
  if (filter != SELVAGE_FILTER_NEAREST && !is_copy(polygon, filter)) {
    return draw_filtered(target, visible, polygon, texture, address, filter);
  }
  const int32_t first_row = std::max(polygon.top_row, visible.top);
  const int32_t end_row = std::min(polygon.bottom_row, visible.bottom);
  if (first_row >= end_row || visible.left >= visible.right) return;
  Chain forward(polygon, Chain::Direction::kForward);
  Chain backward(polygon, Chain::Direction::kBackward);
  const std::optional<Plane> plane = Plane::of(polygon, visible);
  const auto draw_affine = affine_row_kernel(target.format);
  const auto draw_projective = projective_row_kernel(target.format);

  for (int32_t row = first_row; row < end_row; ++row) {
    const Edge& a = forward.at_row(row);
    const Edge& b = backward.at_row(row);
    const bool a_is_left = a.first_px() <= b.first_px();
    const Edge& left = a_is_left ? a : b;
    const Edge& right = a_is_left ? b : a;

    const Span span{.row = row,
                    .left_px = std::max(left.first_px(), visible.left),
                    .right_px = std::min(right.first_px(), visible.right)};
    if (span.empty()) continue;
    char* const pixels = static_cast<char*>(target.pixels) + row * target.pitch;
    if (polygon.untransformed) {
      copy_row(texture, address, span.left_px + polygon.ds, row + polygon.dt, span.width_px(),
               pixels + span.left_px * bytes_per_pixel(target.format));
    } else if (plane) {
      draw_affine(plane->lanes(span), ExactTexel(*plane), span, texture, address, pixels);
    } else {
      const SpanMap map(left.at(row), right.at(row));
      if (polygon.affine) {
        draw_affine(AffineLanes(map, span), ExactTexel(map), span, texture, address, pixels);
      } else {
        draw_projective(ProjectiveLanes(map, span), ExactTexel(map), span, texture, address,
                        pixels);
      }
    }
  }
}

}  // namespace selvage::mapper
