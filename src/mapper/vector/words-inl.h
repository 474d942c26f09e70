// Products of 16-bit numbers. Included once for each SIMD target.
#if defined(SELVAGE_VECTOR_WORDS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SELVAGE_VECTOR_WORDS_INL_H
#undef SELVAGE_VECTOR_WORDS_INL_H
#else
#define SELVAGE_VECTOR_WORDS_INL_H
#endif

#include "mapper/vector/kernel-inl.h"

HWY_BEFORE_NAMESPACE();
namespace selvage::mapper::HWY_NAMESPACE {
namespace {

// Of neighbouring signed 16-bit numbers.
template <class V>
[[nodiscard]] HWY_INLINE auto word_products(V a, V b) {
  const hn::Repartition<int32_t, hn::DFromV<V>> d;
#if HWY_TARGET == HWY_SSE4 || HWY_TARGET == HWY_AVX2 || HWY_TARGET == HWY_AVX3
  auto unused = hn::Zero(d);
  return hn::ReorderWidenMulAccumulate(d, a, b, hn::Zero(d), unused);
#else
  const auto x = hn::BitCast(d, a), y = hn::BitCast(d, b);
  const auto low = [](auto words) { return hn::ShiftRight<16>(hn::ShiftLeft<16>(words)); };
  return hn::Add(hn::Mul(low(x), low(y)), hn::Mul(hn::ShiftRight<16>(x), hn::ShiftRight<16>(y)));
#endif
}

}  // namespace
}  // namespace selvage::mapper::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
