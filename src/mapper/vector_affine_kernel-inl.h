// Affine spans by vectors, in whichever way is cheapest. Included once for each SIMD target.
#if defined(SELVAGE_VECTOR_AFFINE_KERNEL_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SELVAGE_VECTOR_AFFINE_KERNEL_INL_H
#undef SELVAGE_VECTOR_AFFINE_KERNEL_INL_H
#else
#define SELVAGE_VECTOR_AFFINE_KERNEL_INL_H
#endif

#include "mapper/vector_affine_narrow-inl.h"
#include "mapper/vector_affine_wide-inl.h"

HWY_BEFORE_NAMESPACE();
namespace selvage::mapper::HWY_NAMESPACE {
namespace {

void draw_affine(const AffineSpans& spans, const Surface& surface) {
  const int32_t rows = window_rows(spans.field.step_x, surface.texture);
  const bool narrow = spans.batch.widest_px <= kNarrow_px;
  with_address(surface, [&](auto address) {
    using Address = decltype(address);
    if (rows == 0 && narrow) return draw_narrow<Address>(spans, surface);
    with_pixel(surface.target.format,
               [&](auto pixel) { draw_wide<decltype(pixel), Address>(spans, surface, rows); });
  });
}

}  // namespace
}  // namespace selvage::mapper::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
