// The coordinates of small polygons of one affine map each by quotients without error. Included
// once for each SIMD target.
#if defined(SELVAGE_VECTOR_SMALL_AFFINE_EXACT_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SELVAGE_VECTOR_SMALL_AFFINE_EXACT_INL_H
#undef SELVAGE_VECTOR_SMALL_AFFINE_EXACT_INL_H
#else
#define SELVAGE_VECTOR_SMALL_AFFINE_EXACT_INL_H
#endif

#include "mapper/vector/small_affine-inl.h"

HWY_BEFORE_NAMESPACE();
namespace selvage::mapper::HWY_NAMESPACE {
namespace {

#if SELVAGE_DRAWS_SMALL

// Texels' 16.16, counted from a polygon's origin: floors of numerators over one divisor, and where
// the texture ends, the last ones in it.
class ExactSmallAffine {
 public:
  HWY_INLINE ExactSmallAffine(const SmallAffine& of, size_t i, double divisor, int32_t end_texel)
      : start_(of.start[i]),
        right_(of.right[i]),
        down_(of.down[i]),
        divisor_(hn::Set(RowTag(), divisor)),
        reciprocal_(hn::Div(hn::Set(RowTag(), 1.0), divisor_)),
        most_(hn::Set(D32(), most_fx16(end_texel))) {}

  [[nodiscard]] HWY_INLINE V32 at(const PixelSteps& steps) const {
    const ColumnTag half;
    const Columns lower = floors(hn::LowerHalf(half, steps.right_px),
                                 hn::LowerHalf(half, steps.down_px)),
                  upper = floors(hn::UpperHalf(half, steps.right_px),
                                 hn::UpperHalf(half, steps.down_px));
    return hn::Min(hn::Combine(D32(), upper, lower), most_);
  }

 private:
  // So many texels from the origin the texture ends, or far beyond the polygon.
  static HWY_INLINE int32_t most_fx16(int32_t end_texel) {
    return (HWY_MIN(end_texel, 1 << 8) << kTexelFraction) - 1;
  }
  // Of pixels they are less than 2^kSmallTexelBits; others may be anything.
  struct Unchecked {
    static HWY_INLINE RowNumbers of(RowNumbers value) { return value; }
  };
  [[nodiscard]] HWY_INLINE Columns floors(Columns right_px, Columns down_px) const {
    const RowTag d;
    const RowNumbers across = hn::MulAdd(number(right_px), hn::Set(d, right_), hn::Set(d, start_));
    const RowNumbers n = hn::MulAdd(number(down_px), hn::Set(d, down_), across);
    Unchecked all;
    return low_bits<0>(floor_quotient<0>(n, divisor_, reciprocal_, &all));
  }

  double start_, right_, down_;
  RowNumbers divisor_, reciprocal_;
  V32 most_;
};

// Of the i-th one of some that were set up.
class ExactAffineSmall {
 public:
  HWY_INLINE ExactAffineSmall(const AffineSmalls& of, size_t i, const SmallTexels& texels)
      : u_(of.u, i, of.doubled_area[i], texels.end_s),
        v_(of.v, i, of.doubled_area[i], texels.end_t) {}

  [[nodiscard]] HWY_INLINE LaneVectors at(const PixelSteps& steps, int32_t /*count_px*/) const {
    return {u_.at(steps), v_.at(steps)};
  }

 private:
  ExactSmallAffine u_, v_;
};

#endif

}  // namespace
}  // namespace selvage::mapper::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
