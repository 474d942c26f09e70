// Drawing rows that lie in no plane together: each has a map of its own.
#pragma once

#include <optional>

#include "mapper/affine_slab.h"
#include "mapper/kernel.h"
#include "mapper/polygon.h"
#include "mapper/projective_slab.h"
#include "mapper/slab.h"
#include "mapper/span_batch.h"

namespace selvage::mapper {

// Affine rows of the map's slabs: the part of a polygon.
inline void draw_ruled_affine(const RuledMap& map, const Polygon& polygon, const selvage_rect& part,
                              const Surface& surface, const Kernels& kernels) {
  BatchWalk walk(polygon, part, kernels.find_spans);
  SpanBatch batch;
  RuledRows rows;
  while (walk.next(&batch)) {
    find_lanes(map.slabs(), batch, kernels.find_ruled_lanes, &rows);
    const RuledSpans spans{batch, rows, polygon.texels, ExactMap(map)};
    if (kernels.draw_ruled != nullptr) {
      kernels.draw_ruled(spans, surface);
    } else {
      for_each_row(spans, [&](const AffineSpans& row) { kernels.draw_affine(row, surface); });
    }
  }
}

// A slab's rows in perspective, `part` of its outline; false where one formula is not for all.
[[nodiscard]] inline bool draw_ruled_projective(const Slab& slab, const Polygon& outline,
                                                const selvage_rect& part, const Surface& surface,
                                                const Kernels& kernels) {
  const std::optional<ProjectiveField> field = ruled_field(slab, outline, part);
  if (!field) return false;
  const RuledMap map(slab);
  BatchWalk walk(outline, part, kernels.find_spans);
  SpanBatch batch;
  while (walk.next(&batch)) {
    kernels.draw_projective({batch, *field, outline.texels, ExactMap(map)}, surface);
  }
  return true;
}

}  // namespace selvage::mapper
