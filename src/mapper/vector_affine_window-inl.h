// Narrow affine spans from one window. Included once for each SIMD target.
#if defined(SELVAGE_VECTOR_AFFINE_WINDOW_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SELVAGE_VECTOR_AFFINE_WINDOW_INL_H
#undef SELVAGE_VECTOR_AFFINE_WINDOW_INL_H
#else
#define SELVAGE_VECTOR_AFFINE_WINDOW_INL_H
#endif

#include "mapper/vector_affine_lanes-inl.h"
#include "mapper/vector_one_window-inl.h"

HWY_BEFORE_NAMESPACE();
namespace selvage::mapper::HWY_NAMESPACE {
namespace {

// Modulo 2^64.
[[nodiscard]] HWY_INLINE Lane plus(Lane lane, int32_t steps, Lane step) {
  const auto sum = [steps](int64_t from, int64_t by) {
    return static_cast<int64_t>(static_cast<uint64_t>(from) +
                                static_cast<uint64_t>(steps) * static_cast<uint64_t>(by));
  };
  return {sum(lane.u_fx32, step.u_fx32), sum(lane.v_fx32, step.v_fx32)};
}

// False where some pixel is a near-tie.
template <class Pixel, class Address, class OneWindow>
[[nodiscard]] HWY_INLINE bool draw_from(const OneWindow& window, const AffineSpans& spans,
                                        const Surface& surface) {
  const D32 d;
  const AffineBatch<Address> batch(spans, surface);
  const Lane step_x = spans.field.step_x, step_y = spans.field.step_y;
  Lane at_row = batch.anchor(spans.field.at(0, spans.batch.first_row));  // where px is 0
  ptrdiff_t row_bytes = spans.batch.first_row * surface.target.pitch;
  char* const target = static_cast<char*>(surface.target.pixels);
  V32 changed = hn::Zero(d);
  for (int32_t i = 0; i < spans.batch.rows; ++i) {
    const Span span = spans.batch.span(i);
    auto* pixels = reinterpret_cast<Pixel*>(target + row_bytes) + span.left_px;
    Lane anchor = plus(at_row, span.left_px, step_x);
    int32_t count_px = span.width_px();
    do {
      const LaneVectors lanes = batch.lanes_from(anchor);
      const auto is_pixel = hn::FirstN(d, static_cast<size_t>(count_px));
      changed = hn::IfThenElse(is_pixel, hn::Or(changed, batch.changes(lanes)), changed);
      store_first(window.texels(lanes), count_px, pixels);
      pixels += kLanes;
      count_px -= kLanes;
      anchor = plus(anchor, kLanes, step_x);
    } while (count_px > 0);
    at_row = plus(at_row, 1, step_y);
    row_bytes += surface.target.pitch;
  }
  return !any_bits(changed, ~0xFFFF);
}

// Draws a batch, if one window holds its texels and no pixel is a near-tie.
template <class Pixel, class Address>
[[nodiscard]] HWY_NOINLINE bool draw_one_window(const AffineSpans& spans, const Surface& surface) {
  return with_one_window<Pixel, Address>(spans.texels, surface.texture,
                                         [&](const auto& window) HWY_ATTR {
                                           return draw_from<Pixel, Address>(window, spans, surface);
                                         });
}

}  // namespace
}  // namespace selvage::mapper::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
