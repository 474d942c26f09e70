// A small polygon of one affine map, drawn in two steps: its lanes and its spans, then its pixels.
//
// No processor foresees which row is a polygon's last, and what it has begun ahead is lost there.
// With another polygon's pixels between the two steps, the first one is done by then.
#pragma once

#include <optional>

#include "mapper/exact_row.h"
#include "mapper/kernel.h"
#include "mapper/outline.h"
#include "mapper/plane.h"
#include "mapper/polygon.h"
#include "mapper/span_batch.h"
#include "selvage.h"

namespace selvage::mapper {

class PlaneDraw {
 public:
  // Whether all rows of a part_of() a polygon that is not empty are one batch.
  [[nodiscard]] static bool fits(const Polygon& polygon, const selvage_rect& part) {
    return polygon.affine && part.bottom - part.top <= kRowsPerBatch;
  }

  // Of what fits. Refers to the polygon and the kernels.
  PlaneDraw(const Polygon& polygon, const selvage_rect& part, const Kernels& kernels)
      : plane_(Plane::of(polygon, part, kernels.find_lanes)),
        polygon_(&polygon),
        kernels_(&kernels) {
    if (!plane_) return;
    batch_.first_row = part.top;
    batch_.rows = part.bottom - part.top;
    Outline outline(polygon);
    kernels.find_spans(&outline, part.left, part.right, &batch_);
  }

  // Whether there is such a map. Only then:
  [[nodiscard]] bool has_plane() const { return plane_.has_value(); }
  void draw(const Surface& surface) const {
    kernels_->draw_affine({batch_, plane_->lanes(), polygon_->texels, ExactMap(*plane_)}, surface);
  }

 private:
  std::optional<Plane> plane_;
  const Polygon* polygon_;
  const Kernels* kernels_;
  SpanBatch batch_;
};

}  // namespace selvage::mapper
