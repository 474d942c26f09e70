// The set-up of small triangles, several at once: a lane is a triangle. Included once for each SIMD
// target.
#if defined(SELVAGE_VECTOR_SMALL_SET_UP_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SELVAGE_VECTOR_SMALL_SET_UP_INL_H
#undef SELVAGE_VECTOR_SMALL_SET_UP_INL_H
#else
#define SELVAGE_VECTOR_SMALL_SET_UP_INL_H
#endif

#include <cstddef>

#include "mapper/small_triangles.h"
#include "mapper/vector/small_affine_exact-inl.h"
#include "mapper/vector/small_projective_exact-inl.h"

HWY_BEFORE_NAMESPACE();
namespace selvage::mapper::HWY_NAMESPACE {
namespace {

#if SELVAGE_DRAWS_SMALL

// What one kind of triangles is drawn by.
struct AffineKind {
  using Maps = AffineSmalls;
  using Lanes = AffineSmallLanes;
  using Rows = AffineSmallRows;
  using Exact = ExactAffineSmall;
};
struct ProjectiveKind {
  using Maps = ProjectiveSmalls;
  using Lanes = ProjectiveSmallLanes;
  using Rows = ProjectiveSmallRows;
  using Exact = ExactProjectiveSmall;
};

// Of kRows triangles.
template <class Kind>
struct SmallSetUp {
  SmallEdges edges;
  HWY_ALIGN int32_t s_texel[kRows], t_texel[kRows];  // where texels are counted from
  HWY_ALIGN int32_t shape[kRows];                    // of windows
  typename Kind::Maps maps;

  HWY_INLINE SmallSetUp(const SmallTriangles& triangles, size_t first,
                        const selvage_texture& texture)
      : SmallSetUp({vertices_of(triangles, first, 0), vertices_of(triangles, first, 1),
                    vertices_of(triangles, first, 2)},
                   triangles, first, texture) {}

  [[nodiscard]] HWY_INLINE typename Kind::Exact exact(size_t i,
                                                      const selvage_texture& texture) const {
    const int32_t s = s_texel[i], t = t_texel[i];
    return {maps, i, SmallTexels{s, t, texture.width - s, texture.height - t}};
  }

 private:
  HWY_INLINE SmallSetUp(const SmallVertices& vertices, const SmallTriangles& triangles,
                        size_t first, const selvage_texture& texture)
      : edges(edges_of(Corner(vertices.a), Corner(vertices.b), Corner(vertices.c),
                       triangles.first_row() + first)) {
    const ColumnTag d;
    const SmallWindows windows(vertices, texture);
    hn::Store(windows.s.texel, d, s_texel);
    hn::Store(windows.t.texel, d, t_texel);
    hn::Store(windows.shape, d, shape);
    const SmallFrame frame(vertices, triangles.left_px() + first, triangles.first_row() + first);
    maps.find(triangles, first, vertices, frame, windows);
  }
};

#endif

}  // namespace
}  // namespace selvage::mapper::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
