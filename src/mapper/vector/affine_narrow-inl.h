// Affine spans by strips: narrow ones, and wider ones where vectors have windows. Included once for
// each SIMD target.
#if defined(SELVAGE_VECTOR_AFFINE_NARROW_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SELVAGE_VECTOR_AFFINE_NARROW_INL_H
#undef SELVAGE_VECTOR_AFFINE_NARROW_INL_H
#else
#define SELVAGE_VECTOR_AFFINE_NARROW_INL_H
#endif

#include "mapper/vector/affine_rest-inl.h"
#include "mapper/vector/affine_window_strips-inl.h"
#include "mapper/vector/fetch-inl.h"

HWY_BEFORE_NAMESPACE();
namespace selvage::mapper::HWY_NAMESPACE {
namespace {

// Where vectors have windows, wider rows are drawn by strips, too, if there are some: windows of a
// strip are found with every lane in use and read long after they were written, those of a row are
// not. Up to such widths this was measured to cost less.
inline constexpr int32_t kMostWindowStrips_px = kLanes == 16 ? 512 : 128, kLeastWindowStripRows = 8;

[[nodiscard]] HWY_INLINE bool pays_strips(const SpanBatch& batch, const WindowShape& shape) {
  const bool by_windows = shape.rows != 0 && batch.widest_px <= kMostWindowStrips_px &&
                          batch.rows >= kLeastWindowStripRows;
  return by_windows || is_narrow(batch);
}

// A load for each pixel.
template <class Pixel, class Address, class Fetch>
struct LoadStripDraw {
  static constexpr bool kTellsWhole = false;
  static HWY_INLINE bool is_in_vain() { return false; }

  AffineBatch<Address> batch;
  Fetch* fetch;

  HWY_INLINE bool draw(const AnchoredStrip& strip, int32_t row, int32_t count_px, Pixel* to) {
    const LaneVectors lanes = batch.lanes_from(strip.u_fx16[row], strip.v_fx16[row]);
    if (batch.any_near(lanes)) return false;
    fetch->add(batch.places(lanes), count_px, reinterpret_cast<char*>(to));
    return true;
  }
};

template <class Pixel, class Address, class Fetch>
HWY_NOINLINE void draw_load_strips(const AffineSpans& spans, const Surface& surface,
                                   RestDraw* rest) {
  Fetch fetch(surface.texture.texels);
  const LoadStripDraw<Pixel, Address, Fetch> by{AffineBatch<Address>(spans, surface), &fetch};
  const Lane first = spans.field.at(0, spans.batch.first_row);
  AnchoredStrip strip;
  draw_strips<Pixel>(by, &strip, WideAnchors(spans.field, by.batch.anchor(first)), spans.batch,
                     surface, rest);
  fetch.finish();
}

// By itself, so that small polygons, which one window holds, do without the room that this takes.
template <class Pixel, class Address>
HWY_NOINLINE void draw_by_strips(const AffineSpans& spans, const Surface& surface,
                                 const WindowShape& shape, bool inside, RestDraw* rest) {
  if (kHasWindows && shape.rows != 0) {
    const Lane first = spans.field.at(0, spans.batch.first_row);
    const WideAnchors anchors(spans.field, plus(first, 1, way_to_anchor(spans.field.step_x)));
    with_window_shape<Pixel>(surface, shape, inside,
                             WindowStrips<WideAnchors>{spans, anchors, surface, inside, rest});
  } else if (!is_cached(surface.texture)) {
    draw_load_strips<Pixel, Address, FetchAhead<Pixel>>(spans, surface, rest);
  } else if (inside) {
    draw_load_strips<Pixel, Addressed<InsideVector>, FetchAtOnce<Pixel>>(spans, surface, rest);
  } else {
    draw_load_strips<Pixel, Address, FetchAtOnce<Pixel>>(spans, surface, rest);
  }
}

}  // namespace
}  // namespace selvage::mapper::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
