#include "mapper/draw.h"

#include <optional>

#include "mapper/area_draw.h"
#include "mapper/copy_row.h"
#include "mapper/image.h"
#include "mapper/kernel_choice.h"
#include "mapper/near_plane.h"
#include "mapper/perspective_draw.h"
#include "mapper/plane.h"
#include "mapper/projective_plane.h"
#include "mapper/ruled_draw.h"
#include "mapper/slab.h"
#include "mapper/span_walk.h"
#include "mapper/tolerant_draw.h"

namespace selvage::mapper {
namespace {

// Texel centres on pixel centres, one for one: bilinear weights are 0 and 1, the box is one texel.
[[nodiscard]] bool is_copy(const Polygon& polygon, selvage_filter filter) {
  return polygon.untransformed && filter != SELVAGE_FILTER_FOUR;
}

// u = x + ds and v = y + dt: rows of the texture, byte by byte.
void draw_copies(const Polygon& polygon, const selvage_rect& part, const Surface& surface) {
  SpanWalk walk(polygon, part);
  while (walk.next()) {
    const Span& span = walk.span();
    char* const row = static_cast<char*>(surface.target.pixels) + span.row * surface.target.pitch;
    copy_row(surface.texture, surface.address, span.left_px + polygon.ds, span.row + polygon.dt,
             span.width_px(), row + span.left_px * bytes_per_pixel(surface.target.format));
  }
}

// All rows of a part_of() the polygon by one map.
void draw_affine(const Plane& plane, const Polygon& polygon, const selvage_rect& part,
                 const Surface& surface, const Kernels& kernels) {
  BatchWalk walk(polygon, part, kernels.find_spans);
  SpanBatch batch;
  while (walk.next(&batch)) {
    kernels.draw_affine({batch, plane.lanes(), polygon.texels, ExactMap(plane)}, surface);
  }
}

// The span by the map between its two edges.
void draw_span(const SpanWalk& walk, const Polygon& polygon, const Surface& surface,
               const Kernels& kernels) {
  const SpanMap map = walk.map();
  const Span& span = walk.span();
  if (polygon.affine) {
    const AffineLanes lanes(map, span);
    kernels.draw_affine({one_span(span), lanes.field(span), polygon.texels, ExactMap(map)},
                        surface);
  } else {
    draw_in_perspective(map, span, ProjectiveLanes(map, span), polygon.texels, surface, kernels);
  }
}

// The part of a polygon by one map, if there is one.
[[nodiscard]] bool draw_plane(const Polygon& polygon, const selvage_rect& part,
                              const Surface& surface, const Kernels& kernels) {
  if (polygon.affine) {
    const auto plane = Plane::of(polygon, part, kernels.find_lanes);
    if (plane) draw_affine(*plane, polygon, part, surface, kernels);
    return plane.has_value();
  }
  const auto plane = ProjectivePlane::of(polygon, part);
  if (plane) draw_in_perspective(*plane, polygon, part, surface, kernels);
  return plane.has_value();
}

// A slab by its plane or by the formula of its rows, if there is either.
[[nodiscard]] bool draw_slab(const Slab& slab, const selvage_rect& part, const Surface& surface,
                             const Kernels& kernels) {
  if (slab.rows() < kLeastSlabRows) return false;
  const SlabOutline outline(slab);
  const Polygon polygon = outline.polygon();
  const selvage_rect rows = part_of(polygon, {part.left, slab.first_row, part.right, slab.end_row});
  if (is_empty(rows) || draw_plane(polygon, rows, surface, kernels)) return true;
  if (!polygon.affine) return draw_ruled_projective(slab, polygon, rows, surface, kernels);
  draw_ruled_affine(RuledMap(slab), polygon, rows, surface, kernels);
  return true;
}

void draw_slabs(const Polygon& polygon, const selvage_rect& part, const Surface& surface,
                const Kernels& kernels) {
  SlabWalk slabs(polygon, part);
  SpanWalk spans(polygon, part);
  while (const std::optional<Slab> slab = slabs.next()) {
    if (draw_slab(*slab, part, surface, kernels)) {
      spans.skip_to(slab->end_row);
    } else {
      while (spans.next_above(slab->end_row)) draw_span(spans, polygon, surface, kernels);
    }
  }
}

// The exact map of each row of a polygon, where its slabs are few.
[[nodiscard]] bool find_map(const Polygon& polygon, const selvage_rect& part, RuledMap* map) {
  SlabWalk slabs(polygon, part);
  while (const std::optional<Slab> slab = slabs.next()) {
    if (!map->add(*slab)) return false;
  }
  return true;
}

// A plane near a polygon that lies in none, if there is one and kernels make use of it. Polygons of
// more vertices have mostly too many slabs; n have n - 1 of them at most.
[[nodiscard]] std::optional<AffineField> find_near_plane(const Polygon& polygon,
                                                         const selvage_rect& part,
                                                         const Kernels& kernels) {
  constexpr size_t kMostVertices = RuledMap::kMostSlabs + 1;
  if (kernels.draw_near_plane == nullptr || polygon.vertices.size() > kMostVertices) {
    return std::nullopt;
  }
  return near_plane(polygon, part);
}

void draw_near_plane(const AffineField& lanes, const Polygon& polygon, const selvage_rect& part,
                     const Surface& surface, const Kernels& kernels) {
  RuledMap map;
  static_cast<void>(find_map(polygon, part, &map));
  BatchWalk walk(polygon, part, kernels.find_spans);
  SpanBatch batch;
  while (walk.next(&batch)) {
    kernels.draw_near_plane({batch, lanes, polygon.texels, ExactMap(map)}, surface);
  }
}

// Whether a plane for each slab would cost more than its rows do: where rows are few, and up to
// more of them near a plane, where kernels draw narrow rows as fast as if they lay in it.
[[nodiscard]] bool pays_at_once(const selvage_rect& part, bool is_near_plane) {
  constexpr int32_t kMostRows = 32, kMostNearRows = 128, kMostNear_px = 128;
  const int32_t rows = part.bottom - part.top;
  return rows <= kMostRows ||
         (is_near_plane && rows <= kMostNearRows && part.right - part.left <= kMostNear_px);
}

// All of an affine polygon of few slabs at once.
[[nodiscard]] bool draw_at_once(const Polygon& polygon, const selvage_rect& part,
                                const Surface& surface, const Kernels& kernels) {
  RuledMap map;
  if (!polygon.affine || !find_map(polygon, part, &map)) return false;
  draw_ruled_affine(map, polygon, part, surface, kernels);
  return true;
}

// Affine maps are drawn exactly in any case: their kernels were measured to be no slower than lanes
// that leave near-ties undecided, for what bounds them is fetching texels. So is a polygon of which
// every row is too narrow to be stepped.
[[nodiscard]] bool is_tolerant(const Polygon& polygon, const selvage_options& options,
                               const Kernels& kernels) {
  return options.tolerance > 0 && options.filter == SELVAGE_FILTER_NEAREST && !polygon.affine &&
         polygon.right_px - polygon.left_px >= kernels.stepping.least_row_px && lanes_fit(polygon);
}

}  // namespace

void draw(const Surface& surface, const selvage_rect& visible, const Polygon& polygon,
          const selvage_options& options, const Kernels& kernels) {
  const selvage_rect part = part_of(polygon, visible);
  if (is_empty(part)) return;
  if (is_copy(polygon, options.filter)) return draw_copies(polygon, part, surface);
  if (options.filter == SELVAGE_FILTER_AREA) return draw_area(surface, part, polygon, kernels);
  if (is_tolerant(polygon, options, kernels)) {
    return draw_tolerantly(surface, part, polygon, kernels, options.tolerance);
  }
  if (draw_plane(polygon, part, surface, kernels)) return;
  const std::optional<AffineField> near = find_near_plane(polygon, part, kernels);
  if (near && kernels.pays_near_plane(*near, surface)) {
    return draw_near_plane(*near, polygon, part, surface, kernels);
  }
  if (pays_at_once(part, near.has_value()) && draw_at_once(polygon, part, surface, kernels)) {
    return;
  }
  draw_slabs(polygon, part, surface, kernels);
}

selvage_choice choose(const Surface& surface, const selvage_rect& visible, const Polygon& polygon,
                      const selvage_options& options) {
  const selvage_rect part = part_of(polygon, visible);
  if (!SpanWalk(polygon, part).next()) return {SELVAGE_METHOD_NONE, 0, 0};
  if (is_copy(polygon, options.filter)) return {SELVAGE_METHOD_COPY, 0, 0};
  if (options.filter != SELVAGE_FILTER_NEAREST) return {SELVAGE_METHOD_FILTER, 0, 0};
  const Kernels& kernels = kernels_for(options, surface.texture, polygon);
  if (is_tolerant(polygon, options, kernels)) {
    const RowChoice choice = choose_tolerantly(part, polygon, options.tolerance, kernels.stepping);
    return {choice.method, choice.segment_px, choice.bound_fx16};
  }
  return {polygon.affine ? SELVAGE_METHOD_EXACT_AFFINE : SELVAGE_METHOD_EXACT_PERSPECTIVE, 0, 0};
}

}  // namespace selvage::mapper
