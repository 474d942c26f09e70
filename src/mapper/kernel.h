// The kernels: the inner loops, from lanes to texels to pixels.
//
// Plain types only: a kernel may be replaced by any other that writes the same bytes, and all of
// them do (law SAME).
#pragma once

#include <cstdint>

#include "mapper/affine_slab.h"
#include "mapper/exact_row.h"
#include "mapper/exact_slab.h"
#include "mapper/footprint.h"
#include "mapper/lanes.h"
#include "mapper/plane_lanes.h"
#include "mapper/polygon.h"
#include "mapper/small_polygons.h"
#include "mapper/span_batch.h"
#include "mapper/stepped.h"
#include "selvage.h"

namespace selvage::mapper {

class PlaneFootprint;
struct BoxRow;

// What is drawn on and from. All has passed its checks; the texture shares no byte with the target.
struct Surface {
  selvage_image target;
  selvage_texture texture;
  selvage_address address;
};

// Spans of consecutive rows under one affine map, or near one.
struct AffineSpans {
  const SpanBatch& batch;
  const AffineField& field;
  const TexelBox& texels;  // of all pixels, and maybe of more
  ExactMap exact;          // decides near-ties
};

// Spans of consecutive rows, each under an affine map of its own.
struct RuledSpans {
  const SpanBatch& batch;
  const RuledRows& rows;
  const TexelBox& texels;
  ExactMap exact;
};

// Calls draw(spans) with those of each row by itself.
template <class Draw>
void for_each_row(const RuledSpans& spans, const Draw& draw) {
  const RuledRowFinder rows(spans.exact.ruled());
  for (int32_t i = 0; i < spans.batch.rows; ++i) {
    const Span span = spans.batch.span(i);
    if (span.empty()) continue;
    draw(AffineSpans{one_span(span), spans.rows.lanes(i).field(span), spans.texels,
                     ExactMap::of_rows(rows)});
  }
}

// Spans of consecutive rows under one projective map, or of a slab.
struct ProjectiveSpans {
  const SpanBatch& batch;
  const ProjectiveField& field;
  const TexelBox& texels;
  ExactMap exact;
};

// Each draw_... writes all pixels of the spans by its filter, exactly; draw_stepped, which only
// nearest has, shows the texels of its lanes. draw_small, which only nearest may have, draws
// polygons within its limits in order. Without draw_ruled, rows are drawn one by one;
// draw_near_plane, which only nearest has, too, draws those whose exact map is a RuledMap, where
// pays_near_plane says that this costs less than draw_ruled. Those of the area filter draw boxes of
// any sides, and its other two, which are the bilinear ones, the least boxes.
struct Kernels {
  FindSpans find_spans;
  FindLanes find_lanes;
  FindRuledLanes find_ruled_lanes;
  void (*draw_affine)(const AffineSpans& spans, const Surface& surface);
  void (*draw_projective)(const ProjectiveSpans& spans, const Surface& surface);
  void (*draw_ruled)(const RuledSpans& spans, const Surface& surface) = nullptr;
  bool (*pays_near_plane)(const AffineField& field, const Surface& surface) = nullptr;
  void (*draw_near_plane)(const AffineSpans& spans, const Surface& surface) = nullptr;
  void (*draw_small)(const SmallPolygons& polygons, const Surface& surface) = nullptr;
  SmallLimits small = {};
  void (*draw_stepped)(const SteppedSpans& spans, const Surface& surface) = nullptr;
  void (*draw_boxes_affine)(const AffineSpans& spans, BoxSides sides,
                            const Surface& surface) = nullptr;
  void (*draw_boxes_projective)(const ProjectiveSpans& spans, const PlaneFootprint& footprint,
                                const Surface& surface) = nullptr;
  void (*draw_boxes)(const BoxRow& boxes, const Span& piece, const Surface& surface) = nullptr;
  Stepping stepping = kUsualStepping;
};

void draw_stepped_scalar(const SteppedSpans& spans, const Surface& surface);

[[nodiscard]] const Kernels& scalar_kernels(selvage_filter filter);

}  // namespace selvage::mapper
