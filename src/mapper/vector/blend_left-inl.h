// Batches of the filters over four texels, from windows where there are some. Included once for
// each SIMD target.
#if defined(SELVAGE_VECTOR_BLEND_LEFT_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SELVAGE_VECTOR_BLEND_LEFT_INL_H
#undef SELVAGE_VECTOR_BLEND_LEFT_INL_H
#else
#define SELVAGE_VECTOR_BLEND_LEFT_INL_H
#endif

#include "mapper/vector/blend_affine_windows-inl.h"
#include "mapper/vector/blend_points-inl.h"
#include "mapper/vector/blend_projective_windows-inl.h"

HWY_BEFORE_NAMESPACE();
namespace selvage::mapper::HWY_NAMESPACE {
namespace {

// What windows leave of a batch, a vector at a time.
template <class BlendAnywhere>
HWY_NOINLINE void draw_left(const Left& left, const AffineSpans& spans, const Surface& surface,
                            const BlendAnywhere& anywhere) {
  const AffineSteps steps(spans);
  RowOfTies ties(spans.exact, left.rest[0], kGridBits, 0);
  for (int32_t i = 0; i < left.count; ++i) {
    const Span& rest = left.at(i);
    if (rest.row != ties.span().row) ties.go_to(rest);
    const AffinePoints points(steps, rest.left_px, rest.row, &ties);
    store_pixels(anywhere(points.points()), rest.width_px(),
                 reinterpret_cast<uint32_t*>(first_pixel(surface, rest)));
  }
}

template <class BlendAnywhere>
HWY_NOINLINE void draw_left(const Left& left, const ProjectiveSpans& spans, const Surface& surface,
                            const BlendAnywhere& anywhere) {
  for (int32_t i = 0; i < left.count;) {
    const int32_t row = left.at(i).row;
    const Span span = spans.batch.span(row - spans.batch.first_row);
    RowOfTies ties(spans.exact, span, kGridBits, 0);
    const ProjectiveSteps steps(spans, span);
    for (; i < left.count && left.at(i).row == row; ++i) {
      const Span& rest = left.at(i);
      const ProjectivePoints points(steps, rest.left_px, row, &ties);
      store_pixels(anywhere(points.points()), rest.width_px(),
                   reinterpret_cast<uint32_t*>(first_pixel(surface, rest)));
    }
  }
}

// Whether every second vector or more is left: windows cost more than they save then.
[[nodiscard]] HWY_INLINE bool are_most_left(const Left& left, const SpanBatch& batch) {
  if (left.count < Left::kMost / 2) return false;
  const Span &first = left.at(0), &last = left.at(left.count - 1);
  const int64_t passed_px =
      int64_t{last.row - first.row} * batch.widest_px + (last.left_px - first.left_px);
  return passed_px < 2 * left.count * kLanes;
}

// Returns the first row, counted from the batch's, that is left to others; there may be none.
template <class Spans, class BlendAnywhere>
[[nodiscard]] int32_t draw_by_windows(const Spans& spans, const Surface& surface,
                                      BlendWindows<Spans> windows, const BlendAnywhere& anywhere) {
  Resume at;
  Left left;
  do {
    windows(spans, surface, &at, &left);
    if (left.count != 0) draw_left(left, spans, surface, anywhere);
    if (HWY_UNLIKELY(are_most_left(left, spans.batch))) return at.row;
  } while (at.row < spans.batch.rows);
  return spans.batch.rows;
}

}  // namespace
}  // namespace selvage::mapper::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
