// Affine spans of a polygon whose texels lie in one window, with many near-ties among them.
// Included once for each SIMD target.
#if defined(SELVAGE_VECTOR_AFFINE_TIES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SELVAGE_VECTOR_AFFINE_TIES_INL_H
#undef SELVAGE_VECTOR_AFFINE_TIES_INL_H
#else
#define SELVAGE_VECTOR_AFFINE_TIES_INL_H
#endif

#include "mapper/vector_affine_lanes-inl.h"
#include "mapper/vector_boundaries-inl.h"
#include "mapper/vector_tie_columns-inl.h"

HWY_BEFORE_NAMESPACE();
namespace selvage::mapper::HWY_NAMESPACE {
namespace {

// The narrow rows of a plane from an index in the batch on.
template <class Pixel, class Address>
HWY_INLINE void draw_columns(const AffineSpans& spans, const Surface& surface,
                             int32_t first_index) {
  static_assert(kPlaneAreaBits + kTexelFraction - kLeastSpareBits < 62, "one limb is enough");
  draw_columns<Pixel, Address>(spans.batch, first_index,
                               LowLanes(lack_fx16(spans.field.margin_fx32)),
                               PlaneColumns(spans.field), spans.exact, surface);
}

// Draws a batch of rows of a plane that was drawn from one window in vain.
template <class Pixel, class Address>
HWY_NOINLINE void draw_near_ties(const AffineSpans& spans, const Surface& surface) {
  if (!draw_between_boundaries<Pixel, Address>(spans.batch, TexelRanges(spans.texels), spans.exact,
                                               0, surface)) {
    draw_columns<Pixel, Address>(spans, surface, 0);
  }
}

}  // namespace
}  // namespace selvage::mapper::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
