#include "mapper/tolerant_draw.h"

#include <algorithm>
#include <cstdint>
#include <optional>

#include "mapper/perspective_draw.h"
#include "mapper/projective_plane.h"
#include "mapper/slab.h"
#include "mapper/span_walk.h"
#include "mapper/tolerant_rows.h"

namespace selvage::mapper {
namespace {

[[nodiscard]] std::optional<ProjectivePlane> plane_of(const Polygon& polygon) {
  std::optional<ProjectivePlane> plane = ProjectivePlane::of_all(polygon);
  if (plane && plane->lanes().error_fx32 > kMostSteppedError_fx32) plane.reset();
  return plane;
}

// Whether some row may be stepped.
[[nodiscard]] bool may_step(const PlaneBend& bend, const Polygon& polygon,
                            const Tolerance& tolerance) {
  const auto [near, far] = std::ranges::minmax(polygon.vertices, {}, &selvage_vertex::q);
  // In units of the least one, as the plane's are. Roundings are far below the units of a tolerance
  // that are kept for those of lanes.
  const double most_denominator = static_cast<double>(far.q) / near.q;
  return !bends_too_much(bend.least(most_denominator), tolerance.fx16, tolerance.stepping);
}

// Calls visit.exact(plane, polygon, part) or visit.rows(rows) for a part of a polygon under one
// map; false where it has none.
template <class Visit>
[[nodiscard]] bool visit_plane(const Polygon& polygon, const selvage_rect& part,
                               FindSpans find_spans, const Tolerance& tolerance,
                               const Visit& visit) {
  const auto plane = plane_of(polygon);
  if (!plane) return false;
  const PlaneBend bend(plane->lanes(), polygon.bottom_row - polygon.top_row);
  if (may_step(bend, polygon, tolerance)) {
    visit.rows(PlaneRows(*plane, bend, polygon, part, find_spans, tolerance));
  } else {
    visit.exact(*plane, polygon, part);
  }
  return true;
}

// The same for all of a polygon, slab by slab where it has no map for all of its rows: what is
// visible changes no slab.
template <class Visit>
void visit_all(const Polygon& polygon, const selvage_rect& part, FindSpans find_spans,
               const Tolerance& tolerance, const Visit& visit) {
  if (visit_plane(polygon, part, find_spans, tolerance, visit)) return;
  SlabWalk walk(polygon, {polygon.left_px, polygon.top_row, polygon.right_px, polygon.bottom_row});
  while (const std::optional<Slab> slab = walk.next()) {
    const SlabOutline corners(*slab);
    const Polygon outline = corners.polygon();
    const selvage_rect rows = part_of(outline, {part.left, std::max(part.top, slab->first_row),
                                                part.right, std::min(part.bottom, slab->end_row)});
    if (is_empty(rows) || visit_plane(outline, rows, find_spans, tolerance, visit)) {
      continue;
    }
    visit.rows(SlabRows(*slab, outline, rows, find_spans, tolerance));
  }
}

struct Draw {
  const Surface& surface;
  const Kernels& kernels;

  void exact(const ProjectivePlane& plane, const Polygon& polygon, const selvage_rect& part) const {
    draw_in_perspective(plane, polygon, part, surface, kernels);
  }
  template <class Rows>
  void rows(Rows&& of) const {
    while (of.next()) of.draw(surface, kernels);
  }
};

struct Choose {
  RowChoice* all;

  void add(const RowChoice& row) const {
    const bool shorter = all->segment_px == 0 || row.segment_px < all->segment_px;
    if (row.segment_px != 0 && shorter) all->segment_px = row.segment_px;
    all->method = std::max(all->method, row.method);
    all->bound_fx16 = std::max(all->bound_fx16, row.bound_fx16);
  }
  void exact(const ProjectivePlane& /*plane*/, const Polygon& polygon,
             const selvage_rect& part) const {
    SpanWalk walk(polygon, part);
    while (walk.next()) add({SELVAGE_METHOD_EXACT_PERSPECTIVE, 0, 0});
  }
  template <class Rows>
  void rows(Rows&& of) const {
    while (of.next()) of.for_each_choice([this](const RowChoice& row) { add(row); });
  }
};

}  // namespace

void draw_tolerantly(const Surface& surface, const selvage_rect& part, const Polygon& polygon,
                     const Kernels& kernels, int32_t tolerance_fx16) {
  visit_all(polygon, part, kernels.find_spans, {tolerance_fx16, kernels.stepping},
            Draw{surface, kernels});
}

RowChoice choose_tolerantly(const selvage_rect& part, const Polygon& polygon,
                            int32_t tolerance_fx16, const Stepping& stepping) {
  RowChoice all{SELVAGE_METHOD_NONE, 0, 0};
  visit_all(polygon, part, find_spans_scalar, {tolerance_fx16, stepping}, Choose{&all});
  return all;
}

}  // namespace selvage::mapper
