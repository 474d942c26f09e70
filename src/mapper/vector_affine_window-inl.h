// Affine spans of a polygon whose texels lie in one window. Included once for each SIMD target.
#if defined(SELVAGE_VECTOR_AFFINE_WINDOW_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SELVAGE_VECTOR_AFFINE_WINDOW_INL_H
#undef SELVAGE_VECTOR_AFFINE_WINDOW_INL_H
#else
#define SELVAGE_VECTOR_AFFINE_WINDOW_INL_H
#endif

#include "mapper/vector_affine_exact-inl.h"
#include "mapper/vector_affine_strip-inl.h"

HWY_BEFORE_NAMESPACE();
namespace selvage::mapper::HWY_NAMESPACE {
namespace {

// Draws vectors from one window, and keeps what the lanes of pixels lack changes in them.
template <class Pixel, class Batch, class OneWindow>
struct WindowPainter {
  OneWindow window;
  Batch batch;
  V32 changed = hn::Zero(D32());

  HWY_INLINE bool draw(const AnchoredStrip& strip, int32_t row, int32_t count_px, Pixel* to) {
    const LaneVectors lanes = batch.lanes_from(strip.u_fx16[row], strip.v_fx16[row]);
    changed = draw_first(window, batch, lanes, count_px, changed, to);
    return true;
  }
};

// For who leaves nothing.
struct NoRest {
  static HWY_INLINE bool draw(const Left& /*left*/, int32_t /*first_index*/,
                              int32_t /*of_vectors*/) {
    return true;
  }
};

// Returns, in the high bits of each lane, whether one of its pixels is a near-tie.
template <class Pixel, class Address, class OneWindow>
[[nodiscard]] HWY_INLINE V32 draw_from(const OneWindow& window, const AffineSpans& spans,
                                       const Surface& surface) {
  using Batch = AffineBatch<Address>;
  const WindowPainter<Pixel, Batch, OneWindow> painter{window, Batch(spans, surface)};
  const Lane first = painter.batch.anchor(spans.field.at(0, spans.batch.first_row));
  AnchoredStrip strip;
  NoRest none;
  return draw_strips<Pixel>(painter, &strip, plus(first, -1, window.origin()), spans, surface,
                            &none)
      .changed;
}

// Draws a batch from one window; of an address mode it takes lanes alone, for which any will do.
template <class Pixel>
struct AffineFromWindow {
  const AffineSpans& spans;
  const Surface& surface;
  V32* changed;  // by near-ties

  template <class OneWindow>
  [[nodiscard]] HWY_INLINE bool operator()(const OneWindow& window) const {
    *changed = draw_from<Pixel, Addressed<InsideVector>>(window, spans, surface);
    return true;
  }
};

// Draws a batch, if one window holds its texels and no pixel is a near-tie.
template <class Pixel, class Address>
[[nodiscard]] HWY_INLINE InOneWindow draw_one_window(const AffineSpans& spans,
                                                     const Surface& surface) {
  if (!pays_one_window(spans.batch)) return InOneWindow::kNotInOne;
  V32 changed;
  if (!with_one_window<Pixel, Address>(spans.texels, surface.texture,
                                       AffineFromWindow<Pixel>{spans, surface, &changed})) {
    return InOneWindow::kNotInOne;
  }
  return in_one_window(changed, spans.batch.widest_px);
}

}  // namespace
}  // namespace selvage::mapper::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
