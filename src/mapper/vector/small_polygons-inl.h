// Small polygons from their vertices to their pixels. Included once for each SIMD target.
#if defined(SELVAGE_VECTOR_SMALL_POLYGONS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SELVAGE_VECTOR_SMALL_POLYGONS_INL_H
#undef SELVAGE_VECTOR_SMALL_POLYGONS_INL_H
#else
#define SELVAGE_VECTOR_SMALL_POLYGONS_INL_H
#endif

#include "mapper/vector/entries-inl.h"
#include "mapper/vector/small_list-inl.h"
#include "mapper/vector/small_windows-inl.h"

HWY_BEFORE_NAMESPACE();
namespace selvage::mapper::HWY_NAMESPACE {
#if SELVAGE_DRAWS_SMALL
namespace {

template <class Pixel, class Kind>
HWY_INLINE void draw_small_as(const SmallPolygons& polygons, const Surface& surface) {
  for (size_t first = 0; first < polygons.count(); first += kRows) {
    const SmallSetUp<Kind> set_up(polygons, first, surface.texture);
    draw_small_set<Pixel>(polygons, set_up, first, HWY_MIN(first + kRows, polygons.count()),
                          surface);
  }
}

}  // namespace

void draw_small(const SmallPolygons& polygons, const Surface& surface) {
  with_pixel(surface.target.format, [&](auto pixel) HWY_ATTR {
    using Pixel = decltype(pixel);
    if (!polygons.affine()) return draw_small_as<Pixel, ProjectiveKind>(polygons, surface);
    if (!polygons.have_four()) return draw_small_as<Pixel, AffineKind>(polygons, surface);
    draw_small_as<Pixel, AffineParallelogramKind>(polygons, surface);
  });
}

#endif
}  // namespace selvage::mapper::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
