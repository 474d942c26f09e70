// Small parallelograms among triangles, of which the first three vertices tell all: their edges,
// and what their windows are found by. Included once for each SIMD target.
#if defined(SELVAGE_VECTOR_SMALL_PARALLELOGRAMS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SELVAGE_VECTOR_SMALL_PARALLELOGRAMS_INL_H
#undef SELVAGE_VECTOR_SMALL_PARALLELOGRAMS_INL_H
#else
#define SELVAGE_VECTOR_SMALL_PARALLELOGRAMS_INL_H
#endif

#include <cstddef>

#include "mapper/vector/small_edges-inl.h"

HWY_BEFORE_NAMESPACE();
namespace selvage::mapper::HWY_NAMESPACE {
namespace {

#if SELVAGE_DRAWS_SMALL

// Both sides may have a corner.
struct ParallelogramLines {
  BrokenLine first, second;

  [[nodiscard]] HWY_INLINE Columns one_side(RowNumbers rows_below) const {
    return first.columns(rows_below);
  }
  [[nodiscard]] HWY_INLINE Columns other_side(RowNumbers rows_below) const {
    return second.columns(rows_below);
  }
};

[[nodiscard]] HWY_INLINE Corner select(hn::Mask<RowTag> is, const Corner& yes, const Corner& no) {
  return {hn::IfThenElse(is, yes.x, no.x), hn::IfThenElse(is, yes.y, no.y)};
}

// The top, the bottom, and a corner of each side between them.
struct ParallelogramCorners {
  Corner top, one, other, bottom;

  // Opposite vertices lie about one middle: the highest one is opposite to the lowest one.
  HWY_INLINE explicit ParallelogramCorners(const SmallVertices& of)
      : top(of.a), one(of.b), other(of.a), bottom(of.c) {
    other.x = hn::Sub(hn::Add(top.x, bottom.x), one.x);
    other.y = hn::Sub(hn::Add(top.y, bottom.y), one.y);
    sort(&top, &bottom);
    sort(&one, &other);
    const auto is_turned = hn::Lt(one.y, top.y);
    const Corner above = select(is_turned, one, top), below = select(is_turned, other, bottom);
    one = select(is_turned, top, one);
    other = select(is_turned, bottom, other);
    top = above;
    bottom = below;
  }
  // Of triangles one side has no corner: its upper edge ends where it begins.
  HWY_INLINE ParallelogramCorners(const ParallelogramCorners& four, const SmallCorners& three,
                                  hn::Mask<RowTag> is_four)
      : top(select(is_four, four.top, three.top)),
        one(select(is_four, four.one, three.top)),
        other(select(is_four, four.other, three.middle)),
        bottom(select(is_four, four.bottom, three.bottom)) {}
};

// Of kRows triangles and parallelograms.
class SmallParallelogramEdges {
 public:
  HWY_INLINE SmallParallelogramEdges(const SmallVertices& vertices, const SmallPolygons& polygons,
                                     size_t first)
      : SmallParallelogramEdges({ParallelogramCorners(vertices), SmallCorners(vertices),
                                 hn::Eq(number(counts(polygons, first)), hn::Set(RowTag(), 4))},
                                first_centres_fx8(polygons, first)) {}

  [[nodiscard]] HWY_INLINE ParallelogramLines of(size_t i) const {
    return {one_.of(i), other_.of(i)};
  }

  [[nodiscard]] static HWY_INLINE SmallTexelRanges ranges(const SmallVertices& vertices,
                                                          const SmallPolygons& polygons,
                                                          size_t first) {
    const auto is_four = hn::Eq(counts(polygons, first), hn::Set(ColumnTag(), 4));
    const auto range = [&](Columns a, Columns b, Columns c) HWY_ATTR {
      const Columns fourth = hn::Sub(hn::Add(a, c), b);
      return SmallRange(a, b, c).with(hn::IfThenElse(is_four, fourth, a));
    };
    const auto& [a, b, c] = vertices;
    return {range(a.u, b.u, c.u), range(a.v, b.v, c.v)};
  }

 private:
  HWY_INLINE SmallParallelogramEdges(const ParallelogramCorners& corners, RowNumbers centre_y_fx8)
      : one_(corners.top, corners.one, corners.bottom, centre_y_fx8),
        other_(corners.top, corners.other, corners.bottom, centre_y_fx8) {}

  static HWY_INLINE Columns counts(const SmallPolygons& polygons, size_t first) {
    return hn::LoadU(ColumnTag(), polygons.vertex_count() + first);
  }

  SmallBrokenLines one_, other_;
};

#endif

}  // namespace
}  // namespace selvage::mapper::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
