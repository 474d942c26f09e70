// Affine spans of a polygon whose texels lie in one window, with many near-ties among them.
// Included once for each SIMD target.
#if defined(SELVAGE_VECTOR_AFFINE_TIES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SELVAGE_VECTOR_AFFINE_TIES_INL_H
#undef SELVAGE_VECTOR_AFFINE_TIES_INL_H
#else
#define SELVAGE_VECTOR_AFFINE_TIES_INL_H
#endif

#include "mapper/vector_affine_lanes-inl.h"
#include "mapper/vector_decided_window-inl.h"
#include "mapper/vector_plane_ties-inl.h"

HWY_BEFORE_NAMESPACE();
namespace selvage::mapper::HWY_NAMESPACE {
namespace {

template <class Pixel, class Window, class Batch, class Ties>
HWY_NOINLINE void draw_decided(const Window& window, const Batch& lanes, const AffineSpans& spans,
                               const Surface& surface, Ties* ties) {
  for (int32_t i = 0; i < spans.batch.rows; ++i) {
    const Span span = spans.batch.span(i);
    if (span.empty()) continue;
    ties->go_to(span);
    for (Span rest = span; !rest.empty(); rest.left_px += kLanes) {
      const Lane anchor = lanes.anchor(spans.field.at(rest.left_px, rest.row));
      const int32_t offset_px = rest.left_px - span.left_px;
      window.draw(lanes.decided(*ties, offset_px, lanes.lanes_from(anchor)), rest.width_px(),
                  reinterpret_cast<Pixel*>(first_pixel(surface, rest)));
    }
  }
}

// Draws a batch of rows of a plane that was drawn from one window in vain, if that lies within the
// texture.
template <class Pixel>
[[nodiscard]] HWY_NOINLINE bool draw_near_ties(const AffineSpans& spans, const Surface& surface) {
  static_assert(kPlaneAreaBits + kTexelFraction - kLeastSpareBits < 62, "one limb is enough");
  const TexelRanges texels(spans.texels);
  if (!texels.within(surface.texture)) return false;
  const AffineBatch<Addressed<InsideVector>> lanes(spans, surface);
  const Span first = spans.batch.span(0);
  PlaneTies<OneLimb, ConstantWalk> ties(spans.exact.rows_from(first.left_px, first.row), first);
  with_decided_window<Pixel>(texels, surface.texture, [&](const auto& window) {
    draw_decided<Pixel>(window, lanes, spans, surface, &ties);
  });
  return true;
}

}  // namespace
}  // namespace selvage::mapper::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
