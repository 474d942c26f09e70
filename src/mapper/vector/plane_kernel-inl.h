// The lanes of a plane by vectors of two, u and v. Included once for each SIMD target.
//
// All of it is in double: sums and remainders that are exact, and a quotient rounded to the next
// whole number, of which the sign of its remainder makes the floor. A product and its subtraction
// are rounded once together, or the remainder would not be exact; where the target cannot do so, or
// numbers are too great, lanes are found in integers.
#if defined(SELVAGE_VECTOR_PLANE_KERNEL_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SELVAGE_VECTOR_PLANE_KERNEL_INL_H
#undef SELVAGE_VECTOR_PLANE_KERNEL_INL_H
#else
#define SELVAGE_VECTOR_PLANE_KERNEL_INL_H
#endif

#include "mapper/plane_lanes.h"
#include "mapper/vector/entries-inl.h"
#include "mapper/vector/pair-inl.h"
#include "mapper/vector/plane_quotient-inl.h"

HWY_BEFORE_NAMESPACE();
namespace selvage::mapper::HWY_NAMESPACE {
namespace {

// The greatest magnitude so far.
class Most {
 public:
  HWY_INLINE Most() : most_(hn::Zero(PairTag())) {}

  HWY_INLINE Pair of(Pair value) {
    most_ = hn::Max(most_, hn::Abs(value));
    return value;
  }
  [[nodiscard]] HWY_INLINE bool is_below(double end) const {
    return hn::AllTrue(PairTag(), hn::Lt(most_, hn::Set(PairTag(), end)));
  }

 private:
  Pair most_;
};

HWY_INLINE void store_lane(IntegerPair lane, Lane* to) {
  static_assert(sizeof(Lane) == sizeof(int64_t[2]));
  hn::StoreU(lane, IntegerPairTag(), &to->u_fx32);
}

[[nodiscard]] HWY_INLINE bool find_lanes_in_double(const PlaneFrame& frame, AffineField* lanes) {
  const PairTag d;
  const selvage_vertex &origin = frame.origin(), &second = frame.second(), &third = frame.third();
  const Pair place = xy_of(origin), texel = uv_of(origin);
  const Pair xy2 = hn::Sub(xy_of(second), place), uv2 = hn::Sub(uv_of(second), texel);
  const Pair xy3 = hn::Sub(xy_of(third), place), uv3 = hn::Sub(uv_of(third), texel);
  Most product, estimate;
  const Pair along_x =
      hn::Sub(product.of(hn::Mul(uv2, hn::DupOdd(xy3))), product.of(hn::Mul(uv3, hn::DupOdd(xy2))));
  const Pair along_y = hn::Sub(product.of(hn::Mul(uv3, hn::DupEven(xy2))),
                               product.of(hn::Mul(uv2, hn::DupEven(xy3))));
  const WayToStart way(frame, *lanes);
  const Pair rise =
      hn::Add(product.of(hn::Mul(hn::Set(d, static_cast<double>(way.dx_fx8)), along_x)),
              product.of(hn::Mul(hn::Set(d, static_cast<double>(way.dy_fx8)), along_y)));

  const Pair area = hn::Set(d, static_cast<double>(frame.doubled_area()));
  const Pair reciprocal = hn::Div(hn::Set(d, 1.0), area);
  const IntegerPair origin_fx32 = hn::ShiftLeft<kPlaneStartShift>(whole_uv_of(origin));
  store_lane(
      hn::Add(origin_fx32, floor_quotient<kPlaneStartShift>(rise, area, reciprocal, &estimate)),
      &lanes->start);
  store_lane(floor_quotient<kPlaneStepShift>(along_x, area, reciprocal, &estimate), &lanes->step_x);
  store_lane(floor_quotient<kPlaneStepShift>(along_y, area, reciprocal, &estimate), &lanes->step_y);
  return product.is_below(kMostExactProduct) && estimate.is_below(kMostRounded_fx32);
}

}  // namespace

bool find_lanes(const PlaneFrame& frame, AffineField* lanes) {
#if HWY_NATIVE_FMA
  if (HWY_LIKELY(find_lanes_in_double(frame, lanes))) return true;
#endif
  return find_lanes_scalar(frame, lanes);
}

}  // namespace selvage::mapper::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
