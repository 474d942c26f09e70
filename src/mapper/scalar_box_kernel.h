// Boxes of any sides, for every machine.
#pragma once

#include "mapper/kernel.h"

namespace selvage::mapper {

void draw_boxes_affine_scalar(const AffineSpans& spans, BoxSides sides, const Surface& surface);
void draw_boxes_projective_scalar(const ProjectiveSpans& spans, const PlaneFootprint& footprint,
                                  const Surface& surface);
void draw_boxes_scalar(const BoxRow& boxes, const Span& piece, const Surface& surface);

}  // namespace selvage::mapper
