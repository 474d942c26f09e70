// Affine spans of which each has a map of its own. Included once for each SIMD target.
#if defined(SELVAGE_VECTOR_RULED_KERNEL_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SELVAGE_VECTOR_RULED_KERNEL_INL_H
#undef SELVAGE_VECTOR_RULED_KERNEL_INL_H
#else
#define SELVAGE_VECTOR_RULED_KERNEL_INL_H
#endif

#include "mapper/vector_affine_kernel-inl.h"
#include "mapper/vector_entries-inl.h"

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
      const Lane start = spans.rows.start[static_cast<size_t>(i)];
      const Lane step = spans.rows.step[static_cast<size_t>(i)];
      const LaneVectors steps{steps_fx16(step.u_fx32), steps_fx16(step.v_fx32)};
      changed =
          hn::Or(changed, draw_row(window, fixed,
                                   {start.u_fx32 - origin.u_fx32, start.v_fx32 - origin.v_fx32},
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
      changed = draw_first(window, fixed, lanes, width_px - px, changed, to + px);
      lane.u_fx32 += kLanes * step.u_fx32;
      lane.v_fx32 += kLanes * step.v_fx32;
    }
    return changed;
  }
};

// Lanes of a vector of pixels from an offset in the i-th span on.
[[nodiscard]] HWY_INLINE LaneVectors lanes_of(const RuledRows& rows, int32_t i, int32_t offset_px) {
  const D32 d;
  const Lane step = rows.step[static_cast<size_t>(i)];
  const Lane lane = plus(rows.start[static_cast<size_t>(i)], offset_px, step);
  return {hn::Add(hn::Set(d, floor_fx16(lane.u_fx32)), steps_fx16(step.u_fx32)),
          hn::Add(hn::Set(d, floor_fx16(lane.v_fx32)), steps_fx16(step.v_fx32))};
}

template <class Pixel, class Window>
HWY_NOINLINE void draw_decided(const Window& window, const RuledSpans& spans,
                               const Surface& surface) {
  for (int32_t i = 0; i < spans.batch.rows; ++i) {
    const Span span = spans.batch.span(i);
    auto* const to = reinterpret_cast<Pixel*>(first_pixel(surface, span));
    for (int32_t px = 0; px < span.width_px(); px += kLanes) {
      window.draw(window.offset_px(span) + px, lanes_of(spans.rows, i, px), span.width_px() - px,
                  to + px);
    }
  }
}

template <class Pixel, class Ties>
HWY_INLINE void draw_near_ties_by(Ties ties, const TexelRanges& texels, const RuledSpans& spans,
                                  const Surface& surface) {
  with_decided_window<Pixel>(
      texels, surface, lack_fx16(spans.rows.margin_fx32), &ties,
      [&](const auto& window) { draw_decided<Pixel>(window, spans, surface); });
}

// Draws a batch that was drawn from one window in vain, if that lies within the texture.
template <class Pixel>
[[nodiscard]] HWY_INLINE bool draw_near_ties(const RuledSpans& spans, const Surface& surface) {
  const TexelRanges texels(spans.texels);
  if (!texels.within(surface.texture)) return false;
  const int32_t lack = lack_fx16(spans.rows.margin_fx32);
  if (are_64_enough(static_cast<int128>(spans.rows.most_denominator), spare_bits_fx16(lack))) {
    draw_near_ties_by<Pixel>(RuledTies<OneLimb>(spans.exact), texels, spans, surface);
  } else {
    draw_near_ties_by<Pixel>(RuledTies<TwoLimbs>(spans.exact), texels, spans, surface);
  }
  return true;
}

// As narrow spans of a plane.
template <class Address>
void draw_narrow_ruled(const RuledSpans& spans, const Surface& surface) {
  const SpanBatch& batch = spans.batch;
  const FixedLanes<Address> fixed(surface.texture, lack_fx16(spans.rows.margin_fx32));
  draw_packed<Address>(batch, spans.exact, fixed, surface, [&](int32_t px, int32_t row) HWY_ATTR {
    const int32_t i = row - batch.first_row;
    return lanes_of(spans.rows, i, px - batch.left_px[static_cast<size_t>(i)]);
  });
}

template <class Pixel, class Address>
HWY_NOINLINE void draw_ruled_as(const RuledSpans& spans, const Surface& surface) {
  V32 changed;
  if (pays_one_window(spans.batch) &&
      with_one_window<Pixel, Address>(spans.texels, surface.texture,
                                      RuledFromWindow<Pixel>{spans, surface, &changed})) {
    const InOneWindow in_one = in_one_window(changed, spans.batch.widest_px);
    if (in_one == InOneWindow::kDrawn) return;
    if (in_one == InOneWindow::kManyNearTies && draw_near_ties<Pixel>(spans, surface)) return;
  }
  if (spans.batch.widest_px <= kNarrow_px) return draw_narrow_ruled<Address>(spans, surface);
  for_each_row(spans,
               [&](const AffineSpans& row) { draw_affine_as<Pixel, Address>(row, surface); });
}

}  // namespace

void draw_ruled(const RuledSpans& spans, const Surface& surface) {
  with_address(surface, [&](auto address) {
    with_pixel(surface.target.format, [&](auto pixel) {
      draw_ruled_as<decltype(pixel), decltype(address)>(spans, surface);
    });
  });
}

}  // namespace selvage::mapper::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
