// Small polygons of one affine map each: their coordinates. Included once for each SIMD target.
//
// Maps are whole numbers in double, so few bits long that sums and products are exact, and their
// quotients, as in plane_kernel, which finds the same for one polygon of any size. Lanes walk from
// the part's first pixel by floors of steps in 8.24: those of affine_window, whose law and proof
// they share, where each pixel is its own anchor. Near-ties are found by quotients without error.
#if defined(SELVAGE_VECTOR_SMALL_AFFINE_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SELVAGE_VECTOR_SMALL_AFFINE_INL_H
#undef SELVAGE_VECTOR_SMALL_AFFINE_INL_H
#else
#define SELVAGE_VECTOR_SMALL_AFFINE_INL_H
#endif

#include <cstddef>

#include "mapper/small_polygons.h"
#include "mapper/vector/affine_window-inl.h"
#include "mapper/vector/kernel.h"
#include "mapper/vector/lanes-inl.h"
#include "mapper/vector/plane_quotient-inl.h"
#include "mapper/vector/small_frame-inl.h"
#include "mapper/vector/small_shapes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace selvage::mapper::HWY_NAMESPACE {
namespace {

#if SELVAGE_DRAWS_SMALL

static_assert(HWY_MAX(kSmall.most_columns_texel, kSmall.most_rows_texel) <
                  1 << (31 - kWindowFraction),
              "lanes of 8.24 hold them");

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

// u or v of polygons, each to be picked: counted from the first texel of a window, at the part's
// first pixel, and from there to the right and down.
struct SmallAffine {
  // 1/65536 texel times the doubled area.
  HWY_ALIGN double start[kRows], right[kRows], down[kRows];
  // Lanes of 8.24 and their steps: floors, modulo 2^32. Where the texture ends at a vertex, lanes
  // are lowered, so that none is so far.
  HWY_ALIGN int32_t start_fx24[kRows], right_fx24[kRows], down_fx24[kRows];
};

// Of kRows polygons.
class AffineSmalls {
 public:
  SmallAffine u, v;
  HWY_ALIGN double doubled_area[kRows];

  HWY_INLINE void find(const SmallPolygons& /*polygons*/, size_t /*first*/,
                       const SmallVertices& vertices, const SmallFrame& frame,
                       const SmallWindows& windows) {
    const Finder finder(frame);
    SumOfSquares estimates;
    const auto& [a, b, c] = vertices;
    finder.find(a.u, b.u, c.u, windows.s, &u, &estimates);
    finder.find(a.v, b.v, c.v, windows.t, &v, &estimates);
    hn::Store(frame.doubled_area(), RowTag(), doubled_area);
    have_lanes_ = bits_of(estimates.is_below(kMostRounded_fx32));
  }

  // Whether the lanes of one are what they should be. Not where it has no area: an estimate is
  // infinite there, or no number.
  [[nodiscard]] HWY_INLINE bool has_lanes(size_t i) const { return (have_lanes_ >> i & 1) != 0; }
  [[nodiscard]] HWY_INLINE int32_t lack_fx24(size_t /*i*/) const {
    return kSmallLack_fx24 + kLowered_fx24;
  }

 private:
  class Finder {
   public:
    HWY_INLINE explicit Finder(const SmallFrame& frame)
        : frame_(frame), reciprocal_(hn::Div(hn::Set(RowTag(), 1.0), frame.doubled_area())) {}

    HWY_INLINE void find(Columns a, Columns b, Columns c, const SmallOrigin& origin,
                         SmallAffine* to, SumOfSquares* estimates) const {
      const RowTag d;
      const ColumnTag columns;
      const SmallFrame::Gradient gradient = frame_.gradient(number(a), number(b), number(c));
      const RowNumbers start = frame_.at_first_pixel(from_texel(a, origin.texel), gradient);
      const RowNumbers right = hn::Mul(gradient.along_x, hn::Set(d, kSubpixels)),
                       down = hn::Mul(gradient.along_y, hn::Set(d, kSubpixels));
      hn::Store(start, d, to->start);
      hn::Store(right, d, to->right);
      hn::Store(down, d, to->down);
      const Columns start_fx24 = floor_fx24(start, estimates);
      hn::Store(hn::Sub(start_fx24, origin.lowered_fx24), columns, to->start_fx24);
      hn::Store(floor_fx24(right, estimates), columns, to->right_fx24);
      hn::Store(floor_fx24(down, estimates), columns, to->down_fx24);
    }

   private:
    HWY_INLINE Columns floor_fx24(RowNumbers n, SumOfSquares* estimates) const {
      return low_bits<kWindowShift>(
          floor_quotient<kPlaneStartShift>(n, frame_.doubled_area(), reciprocal_, estimates));
    }

    const SmallFrame& frame_;
    RowNumbers reciprocal_;
  };

  uint32_t have_lanes_;  // a bit each
};

// The lanes of one of them.
class AffineSmallLanes {
 public:
  HWY_INLINE AffineSmallLanes(const AffineSmalls& of, size_t i) : u_(of.u, i), v_(of.v, i) {}

  [[nodiscard]] HWY_INLINE LaneVectors at(const PixelSteps& steps) const {
    return {u_.at(steps), v_.at(steps)};
  }

 private:
  class Line {
   public:
    HWY_INLINE Line(const SmallAffine& of, size_t i)
        : start_(hn::Set(D32(), of.start_fx24[i])),
          right_(hn::Set(D32(), of.right_fx24[i])),
          down_(hn::Set(D32(), of.down_fx24[i])) {}

    [[nodiscard]] HWY_INLINE V32 at(const PixelSteps& steps) const {
      const V32 at_right = hn::Add(start_, hn::Mul(steps.right_px, right_));
      return hn::Add(at_right, hn::Mul(steps.down_px, down_));
    }

   private:
    V32 start_, right_, down_;
  };

  Line u_, v_;
};

// The lanes of its rows, up to kLanes, that begin at some pixels.
class AffineSmallRows {
 public:
  HWY_INLINE AffineSmallRows(const AffineSmalls& of, size_t i, const PixelSteps& begin) {
    const LaneVectors first = AffineSmallLanes(of, i).at(begin);
    hn::Store(first.u, D32(), u_fx24_);
    hn::Store(first.v, D32(), v_fx24_);
  }

  // From a row's first pixel on; kept in registers.
  class Walk {
   public:
    HWY_INLINE Walk(const AffineSmalls& of, size_t i)
        : u_(hn::Mul(hn::Iota(D32(), 0), hn::Set(D32(), of.u.right_fx24[i]))),
          v_(hn::Mul(hn::Iota(D32(), 0), hn::Set(D32(), of.v.right_fx24[i]))) {}

    // The first vector of the k-th row.
    [[nodiscard]] HWY_INLINE LaneVectors along(const AffineSmallRows& rows, int32_t k) const {
      const D32 d;
      return {hn::Add(hn::Set(d, rows.u_fx24_[k]), u_), hn::Add(hn::Set(d, rows.v_fx24_[k]), v_)};
    }

   private:
    V32 u_, v_;
  };

 private:
  HWY_ALIGN int32_t u_fx24_[kLanes], v_fx24_[kLanes];
};

#endif

}  // namespace
}  // namespace selvage::mapper::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
