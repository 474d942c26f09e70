// Quotients by one divisor, a vector of them at a time: whole parts and remainders, stepped by
// additions, without error. Included once for each SIMD target.
#if defined(SELVAGE_VECTOR_QUOTIENTS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SELVAGE_VECTOR_QUOTIENTS_INL_H
#undef SELVAGE_VECTOR_QUOTIENTS_INL_H
#else
#define SELVAGE_VECTOR_QUOTIENTS_INL_H
#endif

#include "mapper/quotient.h"
#include "mapper/vector/kernel-inl.h"

HWY_BEFORE_NAMESPACE();
namespace selvage::mapper::HWY_NAMESPACE {
namespace {

using RestTag = hn::RepartitionToWide<D32>;
using Rests = hn::Vec<RestTag>;

// Remainders are kept less 2^63: signed numbers are compared faster than unsigned ones. Those of
// the even lanes are apart from those of the odd ones, so that carries fall into their places.
struct Quotients {
  V32 whole;
  Rests even, odd;
};

[[nodiscard]] HWY_INLINE int64_t less_half(uint64_t rest) {
  return static_cast<int64_t>(rest ^ uint64_t{1} << 63);
}

// Adds one quotient to all of them. Sums of remainders may leave 64 bits, and are told to reach the
// divisor beforehand: a + b >= d where a > d - 1 - b.
class QuotientSum {
 public:
  HWY_INLINE QuotientSum(const Quotient& by, uint64_t divisor)
      : whole_(hn::Set(D32(), by.whole)),
        rest_(hn::Set(RestTag(), static_cast<int64_t>(by.rest))),
        rest_less_divisor_(hn::Set(RestTag(), static_cast<int64_t>(by.rest - divisor))),
        most_(hn::Set(RestTag(), less_half(divisor - 1 - by.rest))) {}

  [[nodiscard]] HWY_INLINE Quotients of(const Quotients& a) const {
    const D32 d;
    const auto even = hn::Gt(a.even, most_), odd = hn::Gt(a.odd, most_);
    const V32 less_carry = hn::OddEven(hn::BitCast(d, hn::VecFromMask(RestTag(), odd)),
                                       hn::BitCast(d, hn::VecFromMask(RestTag(), even)));
    return {hn::Sub(hn::Add(a.whole, whole_), less_carry),
            hn::Add(a.even, hn::IfThenElse(even, rest_less_divisor_, rest_)),
            hn::Add(a.odd, hn::IfThenElse(odd, rest_less_divisor_, rest_))};
  }

 private:
  V32 whole_;
  Rests rest_, rest_less_divisor_, most_;
};

// Lane i gets i steps; `step` becomes kLanes of them.
[[nodiscard]] HWY_INLINE Quotients walk_by(Quotient* step, uint64_t divisor) {
  HWY_ALIGN int32_t whole[kLanes];
  HWY_ALIGN int64_t rest[2][kLanes / 2];
  Quotient at{0, 0};
  for (int32_t i = 0; i < kLanes; ++i) {
    whole[i] = at.whole;
    rest[i & 1][i / 2] = less_half(at.rest);
    at = sum(at, *step, divisor);
  }
  *step = at;
  return {hn::Load(D32(), whole), hn::Load(RestTag(), rest[0]), hn::Load(RestTag(), rest[1])};
}

}  // namespace
}  // namespace selvage::mapper::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
