// Small polygons' vertices and edges, several polygons at once: a lane is a polygon. Included
// once for each SIMD target.
#if defined(SELVAGE_VECTOR_SMALL_EDGES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SELVAGE_VECTOR_SMALL_EDGES_INL_H
#undef SELVAGE_VECTOR_SMALL_EDGES_INL_H
#else
#define SELVAGE_VECTOR_SMALL_EDGES_INL_H
#endif

#include <cstddef>

#include "mapper/small_polygons.h"
#include "mapper/vector/edge_lines-inl.h"

HWY_BEFORE_NAMESPACE();
namespace selvage::mapper::HWY_NAMESPACE {
namespace {

#if SELVAGE_DRAWS_SMALL

static_assert((kRows == 4 || kRows == 8) && SmallPolygons::kMost % size_t{kRows} == 0);

// Of a vertex of each polygon.
struct VertexColumns {
  Columns x, y, u, v;
};

struct SmallVertices {
  VertexColumns a, b, c;
};

// u or v, the least and the most of each polygon's vertices.
struct SmallRange {
  Columns least, most;

  HWY_INLINE SmallRange(Columns a, Columns b, Columns c)
      : least(hn::Min(hn::Min(a, b), c)), most(hn::Max(hn::Max(a, b), c)) {}
  // With another vertex.
  [[nodiscard]] HWY_INLINE SmallRange with(Columns e) const {
    return {hn::Min(least, e), hn::Max(most, e)};
  }

 private:
  HWY_INLINE SmallRange(Columns from, Columns to) : least(from), most(to) {}
};
struct SmallTexelRanges {
  SmallRange u, v;
};

// Numbers of the i-th polygon, four to each, and of every fourth one from there.
template <class D, class Numbers>
[[nodiscard]] HWY_INLINE hn::Vec<D> every_fourth(D d, const Numbers& numbers, size_t i) {
  if constexpr (hn::MaxLanes(D()) == 4) {
    return numbers(i);
  } else {
    return hn::Combine(d, numbers(i + 4), numbers(i));
  }
}

// The k-th ones of kRows polygons from an index on; of fewer, the last one's again.
[[nodiscard]] HWY_INLINE VertexColumns vertices_of(const SmallPolygons& polygons, size_t first,
                                                   size_t k) {
  const ColumnTag d;
  const hn::Repartition<int64_t, ColumnTag> pairs;
  const auto vertex = [&](size_t i) HWY_ATTR {
    const size_t index = HWY_MIN(first + i, polygons.count() - 1);
    return hn::LoadU(hn::FixedTag<int32_t, 4>(), &polygons.polygon(index).vertices[k].x);
  };
  const auto all = [&](size_t i) HWY_ATTR { return every_fourth(d, vertex, i); };
  const Columns a = all(0), b = all(1), c = all(2), e = all(3);
  const auto xy_ab = hn::BitCast(pairs, hn::InterleaveLower(d, a, b)),
             xy_ce = hn::BitCast(pairs, hn::InterleaveLower(d, c, e)),
             uv_ab = hn::BitCast(pairs, hn::InterleaveUpper(d, a, b)),
             uv_ce = hn::BitCast(pairs, hn::InterleaveUpper(d, c, e));
  return {hn::BitCast(d, hn::InterleaveLower(pairs, xy_ab, xy_ce)),
          hn::BitCast(d, hn::InterleaveUpper(pairs, xy_ab, xy_ce)),
          hn::BitCast(d, hn::InterleaveLower(pairs, uv_ab, uv_ce)),
          hn::BitCast(d, hn::InterleaveUpper(pairs, uv_ab, uv_ce))};
}

[[nodiscard]] HWY_INLINE RowNumbers number(Columns whole) { return hn::PromoteTo(RowTag(), whole); }

// Of each number the bits from some bit on, modulo 2^32.
template <int kShift>
[[nodiscard]] HWY_INLINE Columns low_bits(hn::Vec<hn::Rebind<int64_t, RowTag>> wide) {
  const auto bits = hn::BitCast(hn::Rebind<uint64_t, RowTag>(), wide);
  const auto low = hn::TruncateTo(hn::Rebind<uint32_t, RowTag>(), hn::ShiftRight<kShift>(bits));
  return hn::BitCast(ColumnTag(), low);
}

struct Corner {
  RowNumbers x, y;

  HWY_INLINE explicit Corner(const VertexColumns& vertex)
      : x(number(vertex.x)), y(number(vertex.y)) {}
  HWY_INLINE Corner(RowNumbers at_x, RowNumbers at_y) : x(at_x), y(at_y) {}
};
HWY_INLINE void sort(Corner* upper, Corner* lower) {
  const Corner a = *upper, b = *lower;
  const auto is_turned = hn::Lt(b.y, a.y);
  upper->x = hn::IfThenElse(is_turned, b.x, a.x);
  lower->x = hn::IfThenElse(is_turned, a.x, b.x);
  upper->y = hn::Min(a.y, b.y);
  lower->y = hn::Max(a.y, b.y);
}

// LineVectors of polygons, each to be picked.
class SmallLines {
 public:
  // lines_between() the two, from the row of this centre on.
  HWY_INLINE SmallLines(const Corner& top, const Corner& bottom, RowNumbers centre_y_fx8) {
    const RowTag d;
    const RowNumbers height = hn::Sub(bottom.y, top.y), dx = hn::Sub(bottom.x, top.x);
    const RowNumbers right_by = hn::Add(top.x, hn::Set(d, kHalfPixel)),
                     below_by = hn::Sub(centre_y_fx8, top.y);
    const RowNumbers sum = hn::MulAdd(right_by, height, hn::Mul(below_by, dx));
    hn::Store(hn::Add(sum, hn::Set(d, kUpToHalf - 1)), d, dividend_);
    hn::Store(hn::Mul(dx, hn::Set(d, kSubpixels)), d, step_);
    hn::Store(hn::Div(hn::Set(d, 1.0 / kSubpixels), height), d, reciprocal_);
  }
  [[nodiscard]] HWY_INLINE LineVectors of(size_t i) const {
    const RowTag d;
    return {hn::Set(d, dividend_[i]), hn::Set(d, step_[i]), hn::Set(d, reciprocal_[i])};
  }

 private:
  HWY_ALIGN double dividend_[kRows], step_[kRows], reciprocal_[kRows];
};

// BrokenLines, each to be picked.
class SmallBrokenLines {
 public:
  HWY_INLINE SmallBrokenLines(const Corner& top, const Corner& middle, const Corner& bottom,
                              RowNumbers centre_y_fx8)
      : upper_(top, middle, centre_y_fx8), lower_(middle, bottom, centre_y_fx8) {
    const RowTag d;
    const RowNumbers below_fx8 = hn::Sub(middle.y, centre_y_fx8);
    hn::Store(hn::Mul(below_fx8, hn::Set(d, 1.0 / kSubpixels)), d, corner_);
  }
  [[nodiscard]] HWY_INLINE BrokenLine of(size_t i) const {
    return {upper_.of(i), lower_.of(i), hn::Set(RowTag(), corner_[i])};
  }

 private:
  SmallLines upper_, lower_;
  HWY_ALIGN double corner_[kRows];
};

// Of the rows of parts from an index on, the first ones' centres.
[[nodiscard]] HWY_INLINE RowNumbers first_centres_fx8(const SmallPolygons& polygons, size_t first) {
  const RowTag d;
  const RowNumbers row = number(hn::LoadU(ColumnTag(), polygons.first_row() + first));
  return hn::MulAdd(row, hn::Set(d, kSubpixels), hn::Set(d, kHalfPixel));
}

struct SmallCorners {
  Corner top, middle, bottom;

  HWY_INLINE explicit SmallCorners(const SmallVertices& of)
      : top(of.a), middle(of.b), bottom(of.c) {
    sort(&top, &middle);
    sort(&middle, &bottom);
    sort(&top, &middle);
  }
};

// Of kRows triangles, and what their windows are found by.
class SmallTriangleEdges {
 public:
  HWY_INLINE SmallTriangleEdges(const SmallVertices& vertices, const SmallPolygons& polygons,
                                size_t first)
      : SmallTriangleEdges(SmallCorners(vertices), first_centres_fx8(polygons, first)) {}

  [[nodiscard]] HWY_INLINE TriangleLines of(size_t i) const {
    return {whole_.of(i), broken_.of(i)};
  }

  [[nodiscard]] static HWY_INLINE SmallTexelRanges ranges(const SmallVertices& vertices,
                                                          const SmallPolygons& /*polygons*/,
                                                          size_t /*first*/) {
    const auto& [a, b, c] = vertices;
    return {SmallRange(a.u, b.u, c.u), SmallRange(a.v, b.v, c.v)};
  }

 private:
  HWY_INLINE SmallTriangleEdges(const SmallCorners& corners, RowNumbers centre_y_fx8)
      : whole_(corners.top, corners.bottom, centre_y_fx8),
        broken_(corners.top, corners.middle, corners.bottom, centre_y_fx8) {}

  SmallLines whole_;
  SmallBrokenLines broken_;
};

// The spans of kLanes rows between two columns, no pixels where they are not in the polygon.
struct SmallSpans {
  V32 left_px, right_px;

  // From so many rows below the first one on, between the two sides of a polygon's lines.
  template <class Lines>
  HWY_INLINE SmallSpans(const Lines& lines, int32_t down_px, int32_t first_px, int32_t end_px) {
    static_assert(kLanes == 2 * kRows);
    const D32 d;
    const RowNumbers upper = hn::Iota(RowTag(), down_px),
                     lower = hn::Iota(RowTag(), down_px + kRows);
    const V32 a = hn::Combine(d, lines.one_side(lower), lines.one_side(upper));
    const V32 b = hn::Combine(d, lines.other_side(lower), lines.other_side(upper));
    left_px = hn::Max(hn::Min(a, b), hn::Set(d, first_px));
    right_px = hn::Max(hn::Min(hn::Max(a, b), hn::Set(d, end_px)), left_px);
  }
};

#endif

}  // namespace
}  // namespace selvage::mapper::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
