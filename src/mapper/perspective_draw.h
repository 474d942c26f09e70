// Drawing exactly in perspective: all rows by one map, or each by its own.
#pragma once

#include "mapper/gentle_pieces.h"
#include "mapper/kernel.h"
#include "mapper/lanes.h"
#include "mapper/polygon.h"
#include "mapper/projective_plane.h"
#include "mapper/span.h"
#include "mapper/span_batch.h"
#include "selvage.h"

namespace selvage::mapper {

static_assert(kGentleRatio <= kMostReach, "kernels count on lanes that lack no more");

// All rows of a part_of() the polygon by one map.
inline void draw_in_perspective(const ProjectivePlane& plane, const Polygon& polygon,
                                const selvage_rect& part, const Surface& surface,
                                const Kernels& kernels) {
  BatchWalk walk(polygon, part, kernels.find_spans);
  SpanBatch batch;
  while (walk.next(&batch)) {
    kernels.draw_projective({batch, plane.lanes(), polygon.texels, ExactMap(plane)}, surface);
  }
}

// A span by the map between its two edges; `lanes` are its own.
inline void draw_in_perspective(const SpanMap& map, const Span& span, const ProjectiveLanes& lanes,
                                const TexelBox& texels, const Surface& surface,
                                const Kernels& kernels) {
  const auto draw = [&](const Span& part, const ProjectiveLanes& part_lanes) {
    kernels.draw_projective({one_span(part), part_lanes.field(part), texels, ExactMap(map)},
                            surface);
  };
  if (lanes.ratio() <= kGentleRatio) return draw(span, lanes);
  for_each_gentle_piece(span, lanes.denominator().step > 0,
                        [&](const Span& piece) { draw(piece, ProjectiveLanes(map, piece)); });
}

}  // namespace selvage::mapper
