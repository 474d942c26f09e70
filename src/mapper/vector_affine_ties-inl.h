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
#include "mapper/vector_fetch-inl.h"
#include "mapper/vector_plane_ties-inl.h"

HWY_BEFORE_NAMESPACE();
namespace selvage::mapper::HWY_NAMESPACE {
namespace {

// Draws a batch of rows of a plane that was drawn from one window in vain.
template <class Pixel, class Address>
HWY_NOINLINE void draw_near_ties(const AffineSpans& spans, const Surface& surface) {
  static_assert(kPlaneAreaBits + kTexelFraction - kLeastSpareBits < 62, "one limb is enough");
  if (draw_between_boundaries<Pixel, Address>(spans.batch, TexelRanges(spans.texels), spans.exact,
                                              0, surface)) {
    return;
  }
  const AffineBatch<Addressed<InsideVector>> lanes(spans, surface);  // for its lanes alone
  const Span first = spans.batch.span(0);
  PlaneTies<OneLimb, ConstantWalk> ties(spans.exact.rows_from(first.left_px, first.row), first);
  const TexelFetch<Pixel, Address> fetch(surface.texture);
  for (int32_t i = 0; i < spans.batch.rows; ++i) {
    const Span span = spans.batch.span(i);
    if (span.empty()) continue;
    ties.go_to(span);
    const Lane start = lanes.anchor(spans.field.at(span.left_px, span.row));
    auto* const to = reinterpret_cast<Pixel*>(first_pixel(surface, span));
    for_each_vector_of(span, [&](int32_t px, int32_t count_px) HWY_ATTR {
      const Lane anchor = plus(start, px, spans.field.step_x);
      const TexelVectors texels = lanes.decided(ties, px, lanes.lanes_from(anchor));
      fetch.draw(texels.s, texels.t, count_px, to + px);
    });
  }
}

}  // namespace
}  // namespace selvage::mapper::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
