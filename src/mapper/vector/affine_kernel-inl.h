// Affine spans by vectors, in whichever way is cheapest. Included once for each SIMD target.
#if defined(SELVAGE_VECTOR_AFFINE_KERNEL_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SELVAGE_VECTOR_AFFINE_KERNEL_INL_H
#undef SELVAGE_VECTOR_AFFINE_KERNEL_INL_H
#else
#define SELVAGE_VECTOR_AFFINE_KERNEL_INL_H
#endif

#include "mapper/vector/affine_narrow-inl.h"
#include "mapper/vector/affine_pair_strips-inl.h"
#include "mapper/vector/affine_ties-inl.h"
#include "mapper/vector/affine_wide-inl.h"
#include "mapper/vector/affine_window-inl.h"
#include "mapper/vector/entries-inl.h"

HWY_BEFORE_NAMESPACE();
namespace selvage::mapper::HWY_NAMESPACE {
namespace {

template <class Pixel, class Address>
HWY_INLINE void draw_by_vectors(const AffineSpans& spans, const Surface& surface,
                                const WindowShape& shape, RestDraw* rest) {
  const bool inside = shows_texture_alone(spans, surface.texture);
  const WindowShape of_pairs = inside ? pair_shape(spans, surface.texture, shape) : WindowShape{};
  if constexpr (kHasPairs) {
    if (of_pairs.rows != 0 && pays_pair_strips(spans, surface.texture)) {
      return with_pair_shape<Pixel>(of_pairs, PairStrips{spans, surface, rest});
    }
  }
  if (of_pairs.rows == 0 && pays_strips(spans.batch, shape)) {
    return draw_by_strips<Pixel, Address>(spans, surface, shape, inside, rest);
  }
  draw_wide<Pixel, Address>(spans, surface, shape, of_pairs, inside, rest);
}

// So few pixels that finding their windows would cost more than they do one by one, as measured on
// AMD's family 26: a fifth of a polygon of one pixel, nothing any more of four.
[[nodiscard]] HWY_INLINE bool is_tiny(const SpanBatch& batch) {
  return batch.rows <= 2 && batch.widest_px <= 2;
}

// Returns whether there were many near-ties.
template <class Pixel, class Address>
HWY_NOINLINE bool draw_affine_as(const AffineSpans& spans, const Surface& surface) {
  const InOneWindow in_one = draw_one_window<Pixel, Address>(spans, surface);
  if (in_one == InOneWindow::kDrawn) return false;
  if (in_one == InOneWindow::kManyNearTies && draw_near_ties<Pixel, Address>(spans, surface, 0)) {
    return true;
  }
  const WindowShape shape = window_shape(spans.field.step_x, surface.texture);
  auto rest = AffineRest::of<Pixel, Address>(spans, surface, shape.rows);
  draw_by_vectors<Pixel, Address>(spans, surface, shape, &rest);
  return rest.had_many();
}

}  // namespace

void draw_affine(const AffineSpans& spans, const Surface& surface) {
  if (is_tiny(spans.batch)) {
    return scalar_kernels(SELVAGE_FILTER_NEAREST).draw_affine(spans, surface);
  }
  with_address(surface, [&](auto address) {
    with_pixel(surface.target.format, [&](auto pixel) {
      draw_affine_as<decltype(pixel), decltype(address)>(spans, surface);
    });
  });
}

}  // namespace selvage::mapper::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
