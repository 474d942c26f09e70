#include "mapper/area_draw.h"

#include <cstddef>

#include "mapper/box_row.h"
#include "mapper/filter_point.h"
#include "mapper/footprint.h"
#include "mapper/lanes.h"
#include "mapper/plane.h"
#include "mapper/plane_footprint.h"
#include "mapper/projective_plane.h"
#include "mapper/span.h"
#include "mapper/span_batch.h"
#include "mapper/span_walk.h"

namespace selvage::mapper {
namespace {

// Box by box, where no one map holds for all rows.
template <class Lanes>
void draw_row(const SpanMap& map, const Lanes& lanes, const Span& span, const Footprint& footprint,
              const Surface& surface, const Kernels& kernels) {
  BoxRow boxes;
  for_each_box_piece(span, [&](const Span& piece) {
    for (int32_t i = 0; i < piece.width_px(); ++i) {
      const int32_t px = piece.left_px + i;
      boxes.set(i, filter_point(ExactMap(map), span, lanes, px), footprint.at(px));
    }
    kernels.draw_boxes(boxes, piece, surface);
  });
}

void draw_ruled(const Surface& surface, const selvage_rect& part, const Polygon& polygon,
                const Kernels& kernels) {
  SpanWalk walk(polygon, part);
  while (walk.next()) {
    const Span& span = walk.span();
    const Edge &left = walk.left(), &right = walk.right();
    const Footprint footprint(left.at(span.row), left.change(), right.at(span.row), right.change());
    const SpanMap map = walk.map();
    if (polygon.affine) {
      draw_row(map, AffineLanes(map, span).field(span), span, footprint, surface, kernels);
    } else {
      draw_row(map, ProjectiveLanes(map, span), span, footprint, surface, kernels);
    }
  }
}

// Calls draw(spans) for all spans of a polygon under one map.
template <class Spans, class Plane, class Draw>
void for_each_batch(const Plane& plane, const Polygon& polygon, const selvage_rect& part,
                    FindSpans find_spans, const Draw& draw) {
  BatchWalk walk(polygon, part, find_spans);
  SpanBatch batch;
  while (walk.next(&batch)) draw(Spans{batch, plane.lanes(), polygon.texels, ExactMap(plane)});
}

void draw_affine(const Plane& plane, const Surface& surface, const selvage_rect& part,
                 const Polygon& polygon, const Kernels& kernels) {
  const BoxSides sides = affine_sides(PlaneFrame::of(polygon.vertices));
  const bool is_least = sides == BoxSides{kLeastSide_fx8, kLeastSide_fx8};
  for_each_batch<AffineSpans>(plane, polygon, part, kernels.find_spans,
                              [&](const AffineSpans& spans) {
                                if (is_least) return kernels.draw_affine(spans, surface);
                                kernels.draw_boxes_affine(spans, sides, surface);
                              });
}

void draw_projective(const ProjectivePlane& plane, const Surface& surface, const selvage_rect& part,
                     const Polygon& polygon, const Kernels& kernels) {
  const PlaneFootprint footprint(polygon, part, plane.lanes());
  const bool is_least = footprint.is_least();
  for_each_batch<ProjectiveSpans>(plane, polygon, part, kernels.find_spans,
                                  [&](const ProjectiveSpans& spans) {
                                    if (is_least) return kernels.draw_projective(spans, surface);
                                    kernels.draw_boxes_projective(spans, footprint, surface);
                                  });
}

}  // namespace

void draw_area(const Surface& surface, const selvage_rect& part, const Polygon& polygon,
               const Kernels& kernels) {
  if (polygon.affine) {
    if (const auto plane = Plane::of(polygon, part, kernels.find_lanes)) {
      return draw_affine(*plane, surface, part, polygon, kernels);
    }
  } else if (const auto plane = ProjectivePlane::of(polygon, part)) {
    return draw_projective(*plane, surface, part, polygon, kernels);
  }
  draw_ruled(surface, part, polygon, kernels);
}

}  // namespace selvage::mapper
