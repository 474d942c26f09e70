// Small triangles from their vertices to their pixels. Included once for each SIMD target.
//
// Lanes walk from the part's first pixel by floors of steps in 8.24: those of affine_window, whose
// law and proof they share, where each pixel is its own anchor. Near-ties are found by quotients
// without error.
#if defined(SELVAGE_VECTOR_SMALL_TRIANGLES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SELVAGE_VECTOR_SMALL_TRIANGLES_INL_H
#undef SELVAGE_VECTOR_SMALL_TRIANGLES_INL_H
#else
#define SELVAGE_VECTOR_SMALL_TRIANGLES_INL_H
#endif

#include "mapper/vector/entries-inl.h"
#include "mapper/vector/small_list-inl.h"
#include "mapper/vector/small_windows-inl.h"

HWY_BEFORE_NAMESPACE();
namespace selvage::mapper::HWY_NAMESPACE {
#if SELVAGE_DRAWS_SMALL
namespace {

static_assert(HWY_MAX(kSmall.most_columns_texel, kSmall.most_rows_texel) <
                  1 << (31 - kWindowFraction),
              "lanes of 8.24 hold them");

template <class Pixel>
HWY_INLINE void draw_small_as(const SmallTriangles& triangles, const Surface& surface) {
  for (size_t first = 0; first < triangles.count(); first += kRows) {
    const SmallSetUp set_up(triangles, first, surface.texture);
    draw_small_set<Pixel>(triangles, set_up, first, HWY_MIN(first + kRows, triangles.count()),
                          surface);
  }
}

}  // namespace

void draw_small(const SmallTriangles& triangles, const Surface& surface) {
  with_pixel(surface.target.format,
             [&](auto pixel) HWY_ATTR { draw_small_as<decltype(pixel)>(triangles, surface); });
}

#endif
}  // namespace selvage::mapper::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
