// Affine spans of a polygon whose texels lie in one window. Included once for each SIMD target.
#if defined(SELVAGE_VECTOR_AFFINE_WINDOW_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SELVAGE_VECTOR_AFFINE_WINDOW_INL_H
#undef SELVAGE_VECTOR_AFFINE_WINDOW_INL_H
#else
#define SELVAGE_VECTOR_AFFINE_WINDOW_INL_H
#endif

#include "mapper/vector_affine_exact-inl.h"
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

// A strip of a block: of its rows, a vector each, from so many pixels right of their first ones on;
// whole ones, or parts, maybe of no pixels. Returns what the lanes of pixels lack changes in them.
template <class Pixel, bool kWhole, class Batch, class OneWindow>
[[nodiscard]] HWY_INLINE V32 draw_strip(const OneWindow& window, const Batch& batch,
                                        const AffineSpans& spans, const selvage_image& target,
                                        const RowBlock& block, int32_t right_by_px) {
  const D32 d;
  const Lane step_x = spans.field.step_x, step_y = spans.field.step_y;
  const int32_t* const left_px = spans.batch.left_px.data();
  const int32_t* const right_px = spans.batch.right_px.data();
  const ptrdiff_t pitch = target.pitch;
  const int32_t first_row = spans.batch.first_row + block.first;
  Lane at_row = batch.anchor(spans.field.at(right_by_px, first_row));  // where px is 0
  char* row = static_cast<char*>(target.pixels) + first_row * pitch +
              right_by_px * ptrdiff_t{sizeof(Pixel)};
  V32 changed = hn::Zero(d);
  for (int32_t i = block.first; i < block.end; ++i) {
    const int32_t px = left_px[i], count_px = right_px[i] - px - right_by_px;
    const LaneVectors lanes = batch.lanes_from(plus(at_row, px, step_x));
    Pixel* const to = reinterpret_cast<Pixel*>(row) + px;
    if constexpr (kWhole) {
      changed = hn::Or(changed, batch.changes(lanes));
      store_pixels(window.texels(lanes), kLanes, to);
    } else {
      const auto is_pixel = hn::Gt(hn::Set(d, count_px), hn::Iota(d, 0));
      changed = hn::IfThenElse(is_pixel, hn::Or(changed, batch.changes(lanes)), changed);
      store_first(is_pixel, window.texels(lanes), count_px, to);
    }
    at_row = plus(at_row, 1, step_y);
    row += pitch;
  }
  return changed;
}

// Returns, in the high bits of each lane, whether one of its pixels is a near-tie, and ends where
// some are.
template <class Pixel, class Address, class OneWindow>
[[nodiscard]] HWY_INLINE V32 draw_from(const OneWindow& window, const AffineSpans& spans,
                                       const Surface& surface) {
  const AffineBatch<Address> batch(spans, surface);
  V32 changed = hn::Zero(D32());
  for_each_block(spans.batch, kLanes, [&](const RowBlock& block) HWY_ATTR {
    int32_t px = 0;
    for (; px + kLanes <= block.least_px; px += kLanes) {
      changed =
          hn::Or(changed, draw_strip<Pixel, true>(window, batch, spans, surface.target, block, px));
    }
    for (; px < block.widest_px; px += kLanes) {
      changed = hn::Or(changed, draw_strip<Pixel, false>(window, batch, spans, surface.target,
                                                         block.wider_than(spans.batch, px), px));
    }
    return !any_bits(changed, ~0xFFFF);
  });
  return changed;
}

// What became of a batch: whether it is drawn or, if not, whether near-ties are why, and many.
enum class InOneWindow { kDrawn, kNotDrawn, kManyNearTies };

// Draws a batch, if one window holds its texels and no pixel is a near-tie.
template <class Pixel, class Address>
[[nodiscard]] HWY_NOINLINE InOneWindow draw_one_window(const AffineSpans& spans,
                                                       const Surface& surface) {
  if (!pays_one_window(spans.batch)) return InOneWindow::kNotDrawn;
  V32 changed = hn::Zero(D32());
  if (!with_one_window<Pixel, Address>(
          spans.texels, surface.texture, [&](const auto& window) HWY_ATTR {
            changed = draw_from<Pixel, Address>(window, spans, surface);
            return true;
          })) {
    return InOneWindow::kNotDrawn;
  }
  if (!any_bits(changed, ~0xFFFF)) return InOneWindow::kDrawn;
  const auto near = hn::Ne(hn::ShiftRight<kTexelFraction>(changed), hn::Zero(D32()));
  return hn::CountTrue(D32(), near) < kLeastNear ? InOneWindow::kNotDrawn
                                                 : InOneWindow::kManyNearTies;
}

}  // namespace
}  // namespace selvage::mapper::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
