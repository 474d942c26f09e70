// The set-up of small triangles, several at once: a lane is a triangle. Included once for each SIMD
// target.
//
// Maps are whole numbers in double, so few bits long that sums and products are exact, and
// their quotients, as in row_kernel and plane_kernel, which find the same for one polygon of any
// size.
#if defined(SELVAGE_VECTOR_SMALL_SET_UP_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SELVAGE_VECTOR_SMALL_SET_UP_INL_H
#undef SELVAGE_VECTOR_SMALL_SET_UP_INL_H
#else
#define SELVAGE_VECTOR_SMALL_SET_UP_INL_H
#endif

#include <array>
#include <cstddef>

#include "mapper/small_triangles.h"
#include "mapper/vector/kernel.h"
#include "mapper/vector/lanes-inl.h"
#include "mapper/vector/plane_quotient-inl.h"
#include "mapper/vector/small_edges-inl.h"

HWY_BEFORE_NAMESPACE();
namespace selvage::mapper::HWY_NAMESPACE {
namespace {

#if SELVAGE_DRAWS_SMALL

// Whether some numbers are all so small, by the sum of their squares, which rounding does not make
// less than the greatest of those: one operation a number, where to keep the greatest takes two.
class SumOfSquares {
 public:
  HWY_INLINE SumOfSquares() : sum_(hn::Zero(RowTag())) {}

  HWY_INLINE RowNumbers of(RowNumbers value) {
    sum_ = hn::MulAdd(value, value, sum_);
    return value;
  }
  [[nodiscard]] HWY_INLINE hn::Mask<RowTag> is_below(double end) const {
    return hn::Lt(sum_, hn::Set(RowTag(), end * end));
  }

 private:
  RowNumbers sum_;
};

// The windows that AVX-512 draws triangles from, the smaller ones first: what lies in none is
// loaded texel by texel. In meshes, where nobody foresees how many pixels a row has, that was
// measured to cost more than the largest of them. AVX2 has none: all its texels are loaded.
struct SmallShape {
  int column_bits;
  int32_t vectors;

  [[nodiscard]] constexpr int32_t columns() const { return 1 << column_bits; }
  [[nodiscard]] constexpr int32_t rows() const { return vectors * (kLanes >> column_bits); }
};
#if HWY_TARGET == HWY_AVX3
inline constexpr std::array<SmallShape, 4> kSmallShapes = {
    {{kHalfColumnBits, 2}, {kHalfColumnBits, 4}, {kWindowColumnBits, 8}, {kWindowColumnBits, 12}}};
#else
inline constexpr std::array<SmallShape, 0> kSmallShapes = {};
#endif
inline constexpr int32_t kSmallShapeCount = kSmallShapes.size();

// Where a window begins, u or v, and kLowered_fx24 where lanes are lowered by that.
inline constexpr int32_t kLowered_fx24 = 1;
struct SmallOrigin {
  Columns texel, lowered_fx24;
};

// Which of them, and where they begin: at the least texels, or before them, so that they lie in the
// texture.
struct SmallWindows {
  SmallOrigin s, t;
  Columns shape;

  HWY_INLINE SmallWindows(const VertexColumns& a, const VertexColumns& b, const VertexColumns& c,
                          const selvage_texture& texture) {
    const ColumnTag d;
    const TexelsOf u(a.u, b.u, c.u, texture.width), v(a.v, b.v, c.v, texture.height);
    s = {u.first, u.lowered_fx24};
    t = {v.first, v.lowered_fx24};
    shape = hn::Set(d, kSmallShapeCount);
    for (int32_t i = kSmallShapeCount - 1; i >= 0; --i) {
      const SmallShape window = kSmallShapes[static_cast<size_t>(i)];
      if (texture.width < window.columns() || texture.height < window.rows()) continue;
      const Columns column = hn::Min(u.first, hn::Set(d, texture.width - window.columns()));
      const Columns row = hn::Min(v.first, hn::Set(d, texture.height - window.rows()));
      const auto holds = hn::And(hn::Lt(hn::Sub(u.last, column), hn::Set(d, window.columns())),
                                 hn::Lt(hn::Sub(v.last, row), hn::Set(d, window.rows())));
      s.texel = hn::IfThenElse(holds, column, s.texel);
      t.texel = hn::IfThenElse(holds, row, t.texel);
      shape = hn::IfThenElse(holds, hn::Set(d, i), shape);
    }
  }

 private:
  // Of triangles, the first and the last one that they show.
  struct TexelsOf {
    Columns first, last, lowered_fx24;

    HWY_INLINE TexelsOf(Columns a, Columns b, Columns c, int32_t size_texel) {
      const ColumnTag d;
      const Columns end = hn::Set(d, size_texel);
      const Columns most = hn::ShiftRight<kTexelFraction>(hn::Max(hn::Max(a, b), c));
      const auto is_end = hn::Eq(most, end);
      lowered_fx24 = hn::IfThenElseZero(is_end, hn::Set(d, kLowered_fx24));
      last = hn::Min(most, hn::Sub(end, hn::Set(d, 1)));
      // All three may be the end.
      first = hn::Min(hn::ShiftRight<kTexelFraction>(hn::Min(hn::Min(a, b), c)), last);
    }
  };
};

// u or v of triangles, each to be picked: counted from the first texel of a window, at the part's
// first pixel, and from there to the right and down.
struct SmallCoordinate {
  HWY_ALIGN int32_t origin_texel[kRows];
  // 1/65536 texel times the doubled area.
  HWY_ALIGN double start[kRows], right[kRows], down[kRows];
  // Lanes of 8.24 and their steps: floors, modulo 2^32. Where the texture ends at a vertex, lanes
  // are lowered, so that none is so far.
  HWY_ALIGN int32_t start_fx24[kRows], right_fx24[kRows], down_fx24[kRows];
};

// Maps of triangles from the changes from one vertex to the other two.
class SmallMaps {
 public:
  HWY_INLINE SmallMaps(const VertexColumns& a, const VertexColumns& b, const VertexColumns& c,
                       const int32_t* first_px, const int32_t* first_row)
      : x2_(change(a.x, b.x)),
        y2_(change(a.y, b.y)),
        x3_(change(a.x, c.x)),
        y3_(change(a.y, c.y)),
        dx_(to_centre(first_px, a.x)),
        dy_(to_centre(first_row, a.y)) {
    const RowTag d;
    const RowNumbers area = hn::MulSub(x2_, y3_, hn::Mul(x3_, y2_));
    turn_ = hn::And(area, hn::SignBit(d));
    area_ = hn::Abs(area);
    reciprocal_ = hn::Div(hn::Set(d, 1.0), area_);
  }

  // Of what is such at the three vertices.
  HWY_INLINE void find(Columns a, Columns b, Columns c, const SmallOrigin& origin,
                       SmallCoordinate* to) {
    const RowTag d;
    const ColumnTag columns;
    const RowNumbers to_second = change(a, b), to_third = change(a, c);
    const RowNumbers along_x = cross(to_second, y3_, to_third, y2_),
                     along_y = cross(to_third, x2_, to_second, x3_);
    const RowNumbers from_origin = number(hn::Sub(a, hn::ShiftLeft<kTexelFraction>(origin.texel)));
    const RowNumbers rise = hn::MulAdd(dx_, along_x, hn::Mul(dy_, along_y));
    const RowNumbers start = hn::MulAdd(from_origin, area_, rise);
    const RowNumbers right = hn::Mul(along_x, hn::Set(d, kSubpixels)),
                     down = hn::Mul(along_y, hn::Set(d, kSubpixels));
    hn::Store(origin.texel, columns, to->origin_texel);
    hn::Store(start, d, to->start);
    hn::Store(right, d, to->right);
    hn::Store(down, d, to->down);
    hn::Store(hn::Sub(floor_fx24(start), origin.lowered_fx24), columns, to->start_fx24);
    hn::Store(floor_fx24(right), columns, to->right_fx24);
    hn::Store(floor_fx24(down), columns, to->down_fx24);
  }

  [[nodiscard]] HWY_INLINE RowNumbers doubled_area() const { return area_; }
  // Of which triangles the lanes that were found are what they should be. Not where one has no
  // area: an estimate is infinite there, or no number.
  [[nodiscard]] HWY_INLINE uint32_t have_lanes() const {
    uint8_t bits[8] = {};  // as many as are stored
    hn::StoreMaskBits(RowTag(), estimates_.is_below(kMostRounded_fx32), bits);
    return bits[0];
  }

 private:
  static HWY_INLINE RowNumbers change(Columns from, Columns to) {
    return hn::Sub(number(to), number(from));
  }
  static HWY_INLINE RowNumbers to_centre(const int32_t* px, Columns from_fx8) {
    const ColumnTag d;
    const Columns corner_fx8 = hn::ShiftLeft<kSubpixelBits>(hn::LoadU(d, px));
    return number(hn::Sub(hn::Add(corner_fx8, hn::Set(d, kHalfPixel)), from_fx8));
  }
  // With the sign that it has where vertices run so that the area is not negative.
  [[nodiscard]] HWY_INLINE RowNumbers cross(RowNumbers a, RowNumbers b, RowNumbers c,
                                            RowNumbers e) const {
    return hn::Xor(hn::MulSub(a, b, hn::Mul(c, e)), turn_);
  }
  HWY_INLINE Columns floor_fx24(RowNumbers n) {
    return low_bits<kWindowShift>(
        floor_quotient<kPlaneStartShift>(n, area_, reciprocal_, &estimates_));
  }

  RowNumbers x2_, y2_, x3_, y3_, dx_, dy_, turn_, area_, reciprocal_;
  SumOfSquares estimates_;
};

// Of kRows triangles.
struct SmallSetUp {
  SmallEdges edges;
  SmallCoordinate u, v;
  HWY_ALIGN double doubled_area[kRows];
  HWY_ALIGN int32_t shape[kRows];  // of windows
  uint32_t have_lanes;             // a bit each

  HWY_INLINE SmallSetUp(const SmallTriangles& triangles, size_t first,
                        const selvage_texture& texture)
      : SmallSetUp(vertices_of(triangles, first, 0), vertices_of(triangles, first, 1),
                   vertices_of(triangles, first, 2), triangles, first, texture) {}

 private:
  HWY_INLINE SmallSetUp(const VertexColumns& a, const VertexColumns& b, const VertexColumns& c,
                        const SmallTriangles& triangles, size_t first,
                        const selvage_texture& texture)
      : edges(edges_of(Corner(a), Corner(b), Corner(c), triangles.first_row() + first)) {
    const SmallWindows windows(a, b, c, texture);
    SmallMaps maps(a, b, c, triangles.left_px() + first, triangles.first_row() + first);
    maps.find(a.u, b.u, c.u, windows.s, &u);
    maps.find(a.v, b.v, c.v, windows.t, &v);
    hn::Store(maps.doubled_area(), RowTag(), doubled_area);
    have_lanes = maps.have_lanes();
    hn::Store(windows.shape, ColumnTag(), shape);
  }
};

#endif

}  // namespace
}  // namespace selvage::mapper::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
