// From the sums of a box, side by side, to its mean. Included once for each SIMD target.
#if defined(SELVAGE_VECTOR_BOX_ROUNDING_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SELVAGE_VECTOR_BOX_ROUNDING_INL_H
#undef SELVAGE_VECTOR_BOX_ROUNDING_INL_H
#else
#define SELVAGE_VECTOR_BOX_ROUNDING_INL_H
#endif

#include "mapper/vector/kernel-inl.h"

HWY_BEFORE_NAMESPACE();
namespace selvage::mapper::HWY_NAMESPACE {
namespace {

using DPixel = hn::CappedTag<int32_t, 4>;
using VPixel = hn::Vec<DPixel>;

// (sum + area / 2) / area, floored. With a quarter more it is no closer to a whole number than
// 2^-25, and what its three roundings come to is below 2^-43.
template <class V>
[[nodiscard]] HWY_INLINE uint32_t mean_of(V sums, int32_t area_fx16) {
  const hn::CappedTag<double, 4> d;
  const hn::Rebind<int32_t, decltype(d)> d32;
  const auto half = hn::Set(d, 0.5 * area_fx16 + 0.25);
  const auto reciprocal = hn::Set(d, 1.0 / area_fx16);
  const auto mean = [&](auto some) {
    return hn::DemoteTo(d32, hn::Mul(hn::Add(hn::PromoteTo(d, some), half), reciprocal));
  };
  V means;
  if constexpr (hn::MaxLanes(hn::CappedTag<double, 4>()) == 4) {
    means = mean(sums);
  } else {
    means = hn::Combine(DPixel(), mean(hn::UpperHalf(d32, sums)), mean(hn::LowerHalf(sums)));
  }
  const hn::Rebind<uint8_t, DPixel> d8;
  const hn::Repartition<uint32_t, decltype(d8)> whole;
  return hn::GetLane(hn::BitCast(whole, hn::DemoteTo(d8, means)));
}

template <class V>
[[nodiscard]] HWY_INLINE VPixel blocks_added(V sums) {
  if constexpr (hn::MaxLanes(hn::DFromV<V>()) == 4) {
    return sums;
  } else {
    return hn::Add(hn::LowerHalf(sums), hn::UpperHalf(DPixel(), sums));
  }
}

}  // namespace
}  // namespace selvage::mapper::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
