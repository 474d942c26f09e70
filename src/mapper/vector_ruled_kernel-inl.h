// Affine spans of which each has a map of its own. Included once for each SIMD target.
#if defined(SELVAGE_VECTOR_RULED_KERNEL_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SELVAGE_VECTOR_RULED_KERNEL_INL_H
#undef SELVAGE_VECTOR_RULED_KERNEL_INL_H
#else
#define SELVAGE_VECTOR_RULED_KERNEL_INL_H
#endif

#include "mapper/vector_affine_kernel-inl.h"

HWY_BEFORE_NAMESPACE();
namespace selvage::mapper::HWY_NAMESPACE {
namespace {

// floor(i step) in 2^-16 texel for lane i, whole units and what the fraction adds: of any sign, as
// low as AffineBatch has them from the least lane on.
[[nodiscard]] HWY_INLINE V32 steps_fx16(int64_t step_fx32) {
  const D32 d;
  const V32 i = hn::Iota(d, 0);
  const V32 whole = hn::Mul(i, hn::Set(d, floor_fx16(step_fx32)));
  const V32 fraction = hn::Mul(i, hn::Set(d, static_cast<int32_t>(step_fx32 & 0xFFFF)));
  return hn::Add(whole, hn::ShiftRight<kAnchorShift>(fraction));
}

// Draws a batch from one window, row by row.
template <class Pixel>
struct RuledFromWindow {
  const RuledSpans& spans;
  const Surface& surface;
  V32* changed_by_near;

  template <class OneWindow>
  [[nodiscard]] HWY_INLINE bool operator()(const OneWindow& window) const {
    const FixedLanes<Addressed<InsideVector>> fixed(  // for what its lanes lack alone
        surface.texture, lack_fx16(spans.rows.margin_fx32));
    const Lane origin = window.origin();
    V32 changed = hn::Zero(D32());
    for (int32_t i = 0; i < spans.batch.rows; ++i) {
      const Span span = spans.batch.span(i);
      if (span.empty()) continue;
      const Lane start = spans.rows.start[static_cast<size_t>(i)];
      const Lane step = spans.rows.step[static_cast<size_t>(i)];
      const LaneVectors steps{steps_fx16(step.u_fx32), steps_fx16(step.v_fx32)};
      changed = hn::Or(changed, draw_row(window, fixed, {start.u_fx32 - origin.u_fx32,
                                                         start.v_fx32 - origin.v_fx32},
                                         step, steps, span));
    }
    *changed_by_near = changed;
    return true;
  }

 private:
  template <class OneWindow, class Fixed>
  [[nodiscard]] HWY_INLINE V32 draw_row(const OneWindow& window, const Fixed& fixed, Lane lane,
                                        Lane step, const LaneVectors& steps,
                                        const Span& span) const {
    const D32 d;
    auto* const to = reinterpret_cast<Pixel*>(first_pixel(surface, span));
    const int32_t width_px = span.width_px();
    V32 changed = hn::Zero(d);
    for (int32_t px = 0; px < width_px; px += kLanes) {
      const LaneVectors lanes{hn::Add(hn::Set(d, floor_fx16(lane.u_fx32)), steps.u),
                              hn::Add(hn::Set(d, floor_fx16(lane.v_fx32)), steps.v)};
      const auto is_pixel = hn::Gt(hn::Set(d, width_px - px), hn::Iota(d, 0));
      changed = hn::IfThenElse(is_pixel, hn::Or(changed, fixed.changes(lanes)), changed);
      store_first(is_pixel, window.texels(lanes), width_px - px, to + px);
      lane.u_fx32 += kLanes * step.u_fx32;
      lane.v_fx32 += kLanes * step.v_fx32;
    }
    return changed;
  }
};

// As narrow spans of a plane.
template <class Address>
void draw_narrow_ruled(const RuledSpans& spans, const Surface& surface) {
  const SpanBatch& batch = spans.batch;
  const FixedLanes<Address> fixed(surface.texture, lack_fx16(spans.rows.margin_fx32));
  draw_packed<Address>(batch, spans.exact, fixed, surface, [&](int32_t px, int32_t row) HWY_ATTR {
    const auto i = static_cast<size_t>(row - batch.first_row);
    const Lane step = spans.rows.step[i];
    const Lane lane = plus(spans.rows.start[i], px - batch.left_px[i], step);
    const D32 d;
    return LaneVectors{hn::Add(hn::Set(d, floor_fx16(lane.u_fx32)), steps_fx16(step.u_fx32)),
                       hn::Add(hn::Set(d, floor_fx16(lane.v_fx32)), steps_fx16(step.v_fx32))};
  });
}

template <class Pixel, class Address>
HWY_NOINLINE void draw_ruled_as(const RuledSpans& spans, const Surface& surface) {
  V32 changed;
  if (pays_one_window(spans.batch) &&
      with_one_window<Pixel, Address>(spans.texels, surface.texture,
                                      RuledFromWindow<Pixel>{spans, surface, &changed}) &&
      !any_bits(changed, ~0xFFFF)) {
    return;
  }
  if (spans.batch.widest_px <= kNarrow_px) return draw_narrow_ruled<Address>(spans, surface);
  for_each_row(spans, [&](const AffineSpans& row) { draw_affine_as<Pixel, Address>(row, surface); });
}

void draw_ruled(const RuledSpans& spans, const Surface& surface) {
  with_address(surface, [&](auto address) {
    with_pixel(surface.target.format, [&](auto pixel) {
      draw_ruled_as<decltype(pixel), decltype(address)>(spans, surface);
    });
  });
}

}  // namespace
}  // namespace selvage::mapper::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
