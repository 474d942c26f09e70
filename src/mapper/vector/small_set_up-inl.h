// The set-up of small triangles, several at once: a lane is a triangle. Included once for each SIMD
// target.
//
// All of it is whole numbers in double, so few bits long that sums and products are exact, and
// their quotients, as in row_kernel and plane_kernel, which find the same for one polygon of any
// size.
#if defined(SELVAGE_VECTOR_SMALL_SET_UP_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SELVAGE_VECTOR_SMALL_SET_UP_INL_H
#undef SELVAGE_VECTOR_SMALL_SET_UP_INL_H
#else
#define SELVAGE_VECTOR_SMALL_SET_UP_INL_H
#endif

#include <cstddef>

#include "mapper/small_triangles.h"
#include "mapper/vector/edge_lines-inl.h"
#include "mapper/vector/kernel.h"
#include "mapper/vector/lanes-inl.h"
#include "mapper/vector/plane_quotient-inl.h"

HWY_BEFORE_NAMESPACE();
namespace selvage::mapper::HWY_NAMESPACE {
namespace {

#if HWY_TARGET == HWY_AVX3

static_assert(SmallTriangles::kMost % static_cast<size_t>(kRows) == 0);

// Of a vertex of each triangle.
struct VertexColumns {
  Columns x, y, u, v;
};

// The k-th ones of kRows triangles from an index on; of fewer, the last one's again.
[[nodiscard]] HWY_INLINE VertexColumns vertices_of(const SmallTriangles& triangles, size_t first,
                                                   size_t k) {
  const ColumnTag d;
  const hn::Repartition<int64_t, ColumnTag> pairs;
  const auto vertex = [&](size_t i) HWY_ATTR {
    const size_t index = HWY_MIN(first + i, triangles.count() - 1);
    return hn::LoadU(hn::FixedTag<int32_t, 4>(), &triangles.polygon(index).vertices[k].x);
  };
  const auto both = [&](size_t i) HWY_ATTR { return hn::Combine(d, vertex(i + 4), vertex(i)); };
  const Columns a = both(0), b = both(1), c = both(2), e = both(3);
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

// A bit each.
template <class D>
[[nodiscard]] HWY_INLINE uint32_t bits_of_rows(D d, hn::Mask<D> mask) {
  uint8_t bits[8] = {};  // up to so many may be stored
  hn::StoreMaskBits(d, mask, bits);
  return bits[0];
}

// ---- Edges -------------------------------------------------------------------------------------

struct Corner {
  RowNumbers x, y;

  HWY_INLINE explicit Corner(const VertexColumns& vertex)
      : x(number(vertex.x)), y(number(vertex.y)) {}
};
HWY_INLINE void sort(Corner* upper, Corner* lower) {
  const Corner a = *upper, b = *lower;
  const auto is_turned = hn::Lt(b.y, a.y);
  upper->x = hn::IfThenElse(is_turned, b.x, a.x);
  lower->x = hn::IfThenElse(is_turned, a.x, b.x);
  upper->y = hn::Min(a.y, b.y);
  lower->y = hn::Max(a.y, b.y);
}

// LineVectors of triangles, each to be picked.
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

class SmallEdges {
 public:
  // The corners of triangles, sorted from top to bottom.
  HWY_INLINE SmallEdges(const Corner& top, const Corner& middle, const Corner& bottom,
                        RowNumbers centre_y_fx8)
      : whole_(top, bottom, centre_y_fx8),
        upper_(top, middle, centre_y_fx8),
        lower_(middle, bottom, centre_y_fx8) {
    const RowTag d;
    const RowNumbers below_fx8 = hn::Sub(middle.y, centre_y_fx8);
    hn::Store(hn::Mul(below_fx8, hn::Set(d, 1.0 / kSubpixels)), d, corner_);
  }
  [[nodiscard]] HWY_INLINE TriangleLines of(size_t i) const {
    return {whole_.of(i), upper_.of(i), lower_.of(i), hn::Set(RowTag(), corner_[i])};
  }

 private:
  SmallLines whole_, upper_, lower_;
  HWY_ALIGN double corner_[kRows];
};

[[nodiscard]] HWY_INLINE SmallEdges edges_of(Corner a, Corner b, Corner c,
                                             const int32_t* first_row) {
  const RowTag d;
  sort(&a, &b);
  sort(&b, &c);
  sort(&a, &b);
  const RowNumbers row = number(hn::LoadU(ColumnTag(), first_row));
  return {a, b, c, hn::MulAdd(row, hn::Set(d, kSubpixels), hn::Set(d, kHalfPixel))};
}

// ---- Maps --------------------------------------------------------------------------------------

// Whether some numbers are all so small, by the sum of their squares: rounding does not make it
// less than the greatest of them.
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

// u or v of triangles, each to be picked: counted from the first texel of a window, at the part's
// first pixel, and from there to the right and down.
struct SmallCoordinate {
  HWY_ALIGN int32_t origin_texel[kRows];
  // 1/65536 texel times the doubled area.
  HWY_ALIGN double start[kRows], right[kRows], down[kRows];
  // Lanes of 8.24 and their steps: floors, modulo 2^32.
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
  HWY_INLINE void find(Columns a, Columns b, Columns c, Columns origin_texel, SmallCoordinate* to) {
    const RowTag d;
    const ColumnTag columns;
    const RowNumbers to_second = change(a, b), to_third = change(a, c);
    const RowNumbers along_x = cross(to_second, y3_, to_third, y2_),
                     along_y = cross(to_third, x2_, to_second, x3_);
    const RowNumbers from_origin = number(hn::Sub(a, hn::ShiftLeft<kTexelFraction>(origin_texel)));
    const RowNumbers rise = hn::MulAdd(dx_, along_x, hn::Mul(dy_, along_y));
    const RowNumbers start = hn::MulAdd(from_origin, area_, rise);
    const RowNumbers right = hn::Mul(along_x, hn::Set(d, kSubpixels)),
                     down = hn::Mul(along_y, hn::Set(d, kSubpixels));
    hn::Store(origin_texel, columns, to->origin_texel);
    hn::Store(start, d, to->start);
    hn::Store(right, d, to->right);
    hn::Store(down, d, to->down);
    hn::Store(floor_fx24(start), columns, to->start_fx24);
    hn::Store(floor_fx24(right), columns, to->right_fx24);
    hn::Store(floor_fx24(down), columns, to->down_fx24);
  }

  [[nodiscard]] HWY_INLINE RowNumbers doubled_area() const { return area_; }
  // Of which triangles the lanes that were found are what they should be. Not where one has no
  // area: an estimate is infinite there, or no number.
  [[nodiscard]] HWY_INLINE uint32_t have_lanes() const {
    return bits_of_rows(RowTag(), estimates_.is_below(kMostRounded_fx32));
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

// ---- All of it ---------------------------------------------------------------------------------

// Windows of two sizes.
inline constexpr int kSmallColumnBits = kHalfColumnBits;
inline constexpr int32_t kFewVectors = kRowsPerPermute, kMoreVectors = 2 * kRowsPerPermute;
[[nodiscard]] constexpr int32_t texel_rows_of(int32_t vectors) {
  return vectors * kRowsPerVector<kSmallColumnBits>;
}
static_assert(kSmall.most_columns_texel == kColumns<kSmallColumnBits> &&
              kSmall.most_rows_texel == texel_rows_of(kMoreVectors));

// Where they begin: at the least texels, or before them, so that they lie in the texture.
struct SmallOrigins {
  Columns s, t;
  uint32_t are_tall;  // of the greater size

  HWY_INLINE SmallOrigins(const VertexColumns& a, const VertexColumns& b, const VertexColumns& c,
                          const selvage_texture& texture) {
    const ColumnTag d;
    const auto least = [](Columns x, Columns y, Columns z) HWY_ATTR {
      return hn::ShiftRight<kTexelFraction>(hn::Min(hn::Min(x, y), z));
    };
    const Columns first_t = least(a.v, b.v, c.v);
    const Columns last_t = hn::ShiftRight<kTexelFraction>(hn::Max(hn::Max(a.v, b.v), c.v));
    const auto is_tall =
        hn::Gt(hn::Sub(last_t, first_t), hn::Set(d, texel_rows_of(kFewVectors) - 1));
    const Columns rows = hn::IfThenElse(is_tall, hn::Set(d, texel_rows_of(kMoreVectors)),
                                        hn::Set(d, texel_rows_of(kFewVectors)));
    s = hn::Min(least(a.u, b.u, c.u), hn::Set(d, texture.width - kSmall.most_columns_texel));
    t = hn::Min(first_t, hn::Sub(hn::Set(d, texture.height), rows));
    are_tall = bits_of_rows(d, is_tall);
  }
};

// Of kRows triangles.
struct SmallSetUp {
  SmallEdges edges;
  SmallCoordinate u, v;
  HWY_ALIGN double doubled_area[kRows];
  uint32_t have_lanes, are_tall;  // a bit each

  HWY_INLINE SmallSetUp(const SmallTriangles& triangles, size_t first,
                        const selvage_texture& texture)
      : SmallSetUp(vertices_of(triangles, first, 0), vertices_of(triangles, first, 1),
                   vertices_of(triangles, first, 2), triangles.left_px() + first,
                   triangles.first_row() + first, texture) {}

 private:
  HWY_INLINE SmallSetUp(const VertexColumns& a, const VertexColumns& b, const VertexColumns& c,
                        const int32_t* first_px, const int32_t* first_row,
                        const selvage_texture& texture)
      : edges(edges_of(Corner(a), Corner(b), Corner(c), first_row)) {
    const SmallOrigins origins(a, b, c, texture);
    SmallMaps maps(a, b, c, first_px, first_row);
    maps.find(a.u, b.u, c.u, origins.s, &u);
    maps.find(a.v, b.v, c.v, origins.t, &v);
    hn::Store(maps.doubled_area(), RowTag(), doubled_area);
    have_lanes = maps.have_lanes();
    are_tall = origins.are_tall;
  }
};

#endif

}  // namespace
}  // namespace selvage::mapper::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
