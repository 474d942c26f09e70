#include "mapper/draw.h"

#include <algorithm>
#include <optional>

#include "mapper/area_draw.h"
#include "mapper/copy_row.h"
#include "mapper/image.h"
#include "mapper/kernel.h"
#include "mapper/plane.h"
#include "mapper/span_walk.h"

namespace selvage::mapper {
namespace {

// Texel centres on pixel centres, one for one: bilinear weights are 0 and 1, the box is one texel.
[[nodiscard]] bool is_copy(const Polygon& polygon, selvage_filter filter) {
  return polygon.untransformed && filter != SELVAGE_FILTER_FOUR;
}

// u = x + ds and v = y + dt: rows of the texture, byte by byte.
void draw_copies(const Polygon& polygon, const selvage_rect& visible, const Surface& surface) {
  SpanWalk walk(polygon, visible);
  while (walk.next()) {
    const Span& span = walk.span();
    char* const row = static_cast<char*>(surface.target.pixels) + span.row * surface.target.pitch;
    copy_row(surface.texture, surface.address, span.left_px + polygon.ds, span.row + polygon.dt,
             span.width_px(), row + span.left_px * bytes_per_pixel(surface.target.format));
  }
}

// One affine map for all spans.
void draw_plane(const Plane& plane, const Polygon& polygon, const selvage_rect& visible,
                const Surface& surface, const Kernels& kernels) {
  BatchWalk walk(polygon, visible);
  SpanBatch batch;
  while (walk.next(&batch)) {
    kernels.draw_affine({batch, plane.lanes(), ExactMap(plane)}, surface);
  }
}

// Each span by the map between its own two edges.
void draw_ruled(const Polygon& polygon, const selvage_rect& visible, const Surface& surface,
                const Kernels& kernels) {
  SpanWalk walk(polygon, visible);
  while (walk.next()) {
    const SpanMap map = walk.map();
    const Span& span = walk.span();
    if (polygon.affine) {
      const SpanBatch batch = one_span(span);
      kernels.draw_affine({batch, AffineLanes(map, span).field(span), ExactMap(map)}, surface);
    } else {
      const ProjectiveSpan lanes{span, ProjectiveLanes(map, span)};
      kernels.draw_projective({{&lanes, 1}, ExactMap(map)}, surface);
    }
  }
}

}  // namespace

void draw(const Surface& surface, const selvage_rect& visible, const Polygon& polygon,
          selvage_filter filter, selvage_kernel kernel) {
  if (visible.left >= visible.right ||
      std::max(visible.top, polygon.top_row) >= std::min(visible.bottom, polygon.bottom_row)) {
    return;
  }
  if (is_copy(polygon, filter)) return draw_copies(polygon, visible, surface);
  if (filter == SELVAGE_FILTER_AREA) return draw_area(surface, visible, polygon);
  const Kernels& kernels = kernels_for(kernel, filter, surface, polygon);
  if (const std::optional<Plane> plane = Plane::of(polygon, visible)) {
    return draw_plane(*plane, polygon, visible, surface, kernels);
  }
  draw_ruled(polygon, visible, surface, kernels);
}

}  // namespace selvage::mapper
