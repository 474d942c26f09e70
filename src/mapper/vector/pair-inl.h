// Two numbers of a vertex side by side: x and y, or u and v. Included once for each SIMD target.
#if defined(SELVAGE_VECTOR_PAIR_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SELVAGE_VECTOR_PAIR_INL_H
#undef SELVAGE_VECTOR_PAIR_INL_H
#else
#define SELVAGE_VECTOR_PAIR_INL_H
#endif

#include "mapper/vector/kernel-inl.h"
#include "selvage.h"

HWY_BEFORE_NAMESPACE();
namespace selvage::mapper::HWY_NAMESPACE {
namespace {

using PairTag = hn::FixedTag<double, 2>;
using IntegerPairTag = hn::FixedTag<int64_t, 2>;
using Pair = hn::Vec<PairTag>;
using IntegerPair = hn::Vec<IntegerPairTag>;

[[nodiscard]] HWY_INLINE Pair xy_of(const selvage_vertex& vertex) {
  return hn::PromoteTo(PairTag(), hn::LoadU(hn::FixedTag<int32_t, 2>(), &vertex.x));
}
[[nodiscard]] HWY_INLINE Pair uv_of(const selvage_vertex& vertex) {
  return hn::PromoteTo(PairTag(), hn::LoadU(hn::FixedTag<int32_t, 2>(), &vertex.u));
}
[[nodiscard]] HWY_INLINE IntegerPair whole_uv_of(const selvage_vertex& vertex) {
  return hn::PromoteTo(IntegerPairTag(), hn::LoadU(hn::FixedTag<int32_t, 2>(), &vertex.u));
}

}  // namespace
}  // namespace selvage::mapper::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
