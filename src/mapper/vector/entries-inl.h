// What the tables of a SIMD target hold. Each is compiled in the file of its kind, so that files
// compile side by side. Included once for each SIMD target.
#if defined(SELVAGE_VECTOR_ENTRIES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SELVAGE_VECTOR_ENTRIES_INL_H
#undef SELVAGE_VECTOR_ENTRIES_INL_H
#else
#define SELVAGE_VECTOR_ENTRIES_INL_H
#endif

#include <hwy/highway.h>

#include "mapper/kernel.h"

HWY_BEFORE_NAMESPACE();
namespace selvage::mapper::HWY_NAMESPACE {

// vector/setup.cpp
void find_spans(Outline* outline, int32_t left_px, int32_t right_px, SpanBatch* batch);
[[nodiscard]] bool find_lanes(const PlaneFrame& frame, AffineField* lanes);
void find_ruled_lanes(const AffineSlab& slab, const SpanBatch& batch, int32_t first_index,
                      int32_t end_index, RuledRows* rows);

// vector/affine.cpp
void draw_affine(const AffineSpans& spans, const Surface& surface);
void draw_ruled(const RuledSpans& spans, const Surface& surface);
[[nodiscard]] bool pays_near_plane(const AffineField& field, const Surface& surface);
void draw_near_plane(const AffineSpans& spans, const Surface& surface);

// vector/small.cpp
void draw_small(const SmallPolygons& polygons, const Surface& surface);

// vector/projective.cpp
void draw_projective(const ProjectiveSpans& spans, const Surface& surface);

// vector/stepped.cpp
void draw_stepped(const SteppedSpans& spans, const Surface& surface);

// vector/blend.cpp
void draw_four_affine(const AffineSpans& spans, const Surface& surface);
void draw_four_projective(const ProjectiveSpans& spans, const Surface& surface);
void draw_bilinear_affine(const AffineSpans& spans, const Surface& surface);
void draw_bilinear_projective(const ProjectiveSpans& spans, const Surface& surface);

// vector/box.cpp
void draw_boxes_affine(const AffineSpans& spans, BoxSides sides, const Surface& surface);
void draw_boxes_projective(const ProjectiveSpans& spans, const PlaneFootprint& footprint,
                           const Surface& surface);
void draw_boxes(const BoxRow& boxes, const Span& piece, const Surface& surface);

}  // namespace selvage::mapper::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
