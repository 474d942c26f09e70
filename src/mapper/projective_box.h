// What a projective map is at most in the box around the spans of a batch, in them and beside them.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "mapper/lanes.h"
#include "mapper/span_batch.h"
#include "mapper/steepness.h"

namespace selvage::mapper {

struct ProjectiveBox {
  // Of a field of one map. In units of it; how much it changes by from a pixel to the next, as a
  // share of itself; and how much u and v do. Only where the least one is above 0 the others mean
  // anything.
  double least_denominator, turn, steepest_fx32;

  // Not all spans are empty.
  ProjectiveBox(const ProjectiveField& field, const SpanBatch& batch);
};

// With n = n_0 + x n_x + y n_y, and so d, u changes along x by
//
//     (n_x d - n d_x) / d^2,       whose numerator is linear in y, and does not depend on x,
//
// so that it is largest in the first row or in the last one, and d is least in a corner.
inline ProjectiveBox::ProjectiveBox(const ProjectiveField& field, const SpanBatch& batch) {
  Span box{batch.first_row, INT32_MAX, INT32_MIN};
  for (int32_t i = 0; i < batch.rows; ++i) {
    const Span span = batch.span(i);
    if (span.empty()) continue;
    box.left_px = std::min(box.left_px, span.left_px);
    box.right_px = std::max(box.right_px, span.right_px);
  }
  const int32_t last_px = box.width_px() - 1;
  least_denominator = HUGE_VAL;
  double rise_fx32 = 0;
  for (const int32_t row : {batch.first_row, batch.first_row + batch.rows - 1}) {
    const DividedLanes lanes = field.of({row, box.left_px, box.right_px});
    const DividedLanes::Linear d = lanes.denominator();
    least_denominator = std::min({least_denominator, d.start, d.start + last_px * d.step});
    turn = std::abs(d.step);
    rise_fx32 = std::max({rise_fx32, most_rise(lanes.u_numerator_fx32(), d),
                          most_rise(lanes.v_numerator_fx32(), d)});
  }
  turn /= least_denominator;
  steepest_fx32 = rise_fx32 / (least_denominator * least_denominator);
}

}  // namespace selvage::mapper
