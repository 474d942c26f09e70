// Drawing the rows of a slab that lies in no plane: each has a map of its own.
#pragma once

#include <optional>

#include "mapper/affine_slab.h"
#include "mapper/kernel.h"
#include "mapper/polygon.h"
#include "mapper/projective_slab.h"
#include "mapper/slab.h"
#include "mapper/span_batch.h"

namespace selvage::mapper {

inline void draw_ruled_affine(const RuledMap& map, const Polygon& outline,
                              const selvage_rect& part, const Surface& surface,
                              const Kernels& kernels) {
  const AffineSlab slab(map, part.top);
  BatchWalk walk(outline, part, kernels.find_spans);
  SpanBatch batch;
  RuledRows rows;
  while (walk.next(&batch)) {
    slab.find_lanes(batch, &rows);
    const RuledSpans spans{batch, rows, outline.texels, ExactMap(map)};
    if (kernels.draw_ruled != nullptr) {
      kernels.draw_ruled(spans, surface);
    } else {
      for_each_row(spans, [&](const AffineSpans& row) { kernels.draw_affine(row, surface); });
    }
  }
}

// Rows `part` of a slab with this outline; false where one formula is not for all of them.
[[nodiscard]] inline bool draw_ruled(const RuledMap& map, const Polygon& outline,
                                     const selvage_rect& part, const Surface& surface,
                                     const Kernels& kernels) {
  if (outline.affine) {
    draw_ruled_affine(map, outline, part, surface, kernels);
    return true;
  }
  const std::optional<ProjectiveField> field = ruled_field(map, outline, part);
  if (!field) return false;
  BatchWalk walk(outline, part, kernels.find_spans);
  SpanBatch batch;
  while (walk.next(&batch)) {
    kernels.draw_projective({batch, *field, outline.texels, ExactMap(map)}, surface);
  }
  return true;
}

}  // namespace selvage::mapper
