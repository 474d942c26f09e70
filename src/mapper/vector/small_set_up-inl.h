// The set-up of small polygons, several at once: a lane is a polygon. Included once for each SIMD
// target.
#if defined(SELVAGE_VECTOR_SMALL_SET_UP_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SELVAGE_VECTOR_SMALL_SET_UP_INL_H
#undef SELVAGE_VECTOR_SMALL_SET_UP_INL_H
#else
#define SELVAGE_VECTOR_SMALL_SET_UP_INL_H
#endif

#include <cstddef>

#include "mapper/small_polygons.h"
#include "mapper/vector/small_affine_exact-inl.h"
#include "mapper/vector/small_parallelograms-inl.h"
#include "mapper/vector/small_projective_exact-inl.h"

HWY_BEFORE_NAMESPACE();
namespace selvage::mapper::HWY_NAMESPACE {
namespace {

#if SELVAGE_DRAWS_SMALL

// What one kind of polygons is drawn by.
struct AffineKind {
  using Edges = SmallTriangleEdges;
  using Maps = AffineSmalls;
  using Lanes = AffineSmallLanes;
  using Rows = AffineSmallRows;
  using Exact = ExactAffineSmall;
};
struct AffineParallelogramKind : AffineKind {
  using Edges = SmallParallelogramEdges;
};
struct ProjectiveKind {
  using Edges = SmallTriangleEdges;
  using Maps = ProjectiveSmalls;
  using Lanes = ProjectiveSmallLanes;
  using Rows = ProjectiveSmallRows;
  using Exact = ExactProjectiveSmall;
};

// Of kRows polygons.
template <class Kind>
struct SmallSetUp {
  typename Kind::Edges edges;
  HWY_ALIGN int32_t s_texel[kRows], t_texel[kRows];  // where texels are counted from
  HWY_ALIGN int32_t shape[kRows];                    // of windows
  typename Kind::Maps maps;

  HWY_INLINE SmallSetUp(const SmallPolygons& polygons, size_t first, const selvage_texture& texture)
      : SmallSetUp({vertices_of(polygons, first, 0), vertices_of(polygons, first, 1),
                    vertices_of(polygons, first, 2)},
                   polygons, first, texture) {}

  [[nodiscard]] HWY_INLINE typename Kind::Exact exact(size_t i,
                                                      const selvage_texture& texture) const {
    const int32_t s = s_texel[i], t = t_texel[i];
    return {maps, i, SmallTexels{s, t, texture.width - s, texture.height - t}};
  }

 private:
  HWY_INLINE SmallSetUp(const SmallVertices& vertices, const SmallPolygons& polygons, size_t first,
                        const selvage_texture& texture)
      : edges(vertices, polygons, first) {
    const ColumnTag d;
    const SmallWindows windows(Kind::Edges::ranges(vertices, polygons, first), texture);
    hn::Store(windows.s.texel, d, s_texel);
    hn::Store(windows.t.texel, d, t_texel);
    hn::Store(windows.shape, d, shape);
    const SmallFrame frame(vertices, polygons.left_px() + first, polygons.first_row() + first);
    maps.find(polygons, first, vertices, frame, windows);
  }
};

#endif

}  // namespace
}  // namespace selvage::mapper::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
