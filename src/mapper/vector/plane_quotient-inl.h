// Quotients of whole numbers in double, and their floors: gradients of planes. Included once for
// each SIMD target.
#if defined(SELVAGE_VECTOR_PLANE_QUOTIENT_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SELVAGE_VECTOR_PLANE_QUOTIENT_INL_H
#undef SELVAGE_VECTOR_PLANE_QUOTIENT_INL_H
#else
#define SELVAGE_VECTOR_PLANE_QUOTIENT_INL_H
#endif

#include "mapper/plane_lanes.h"
#include "mapper/vector/kernel-inl.h"

HWY_BEFORE_NAMESPACE();
namespace selvage::mapper::HWY_NAMESPACE {
namespace {

// floor(2^shift n / d), where its magnitude is below kMostRounded_fx32, which whoever calls asks
// `most` that it was told to: spec/proofs/plane_quotient.g.
template <int kShift, class Numbers, class AnyMost>
[[nodiscard]] HWY_INLINE auto floor_quotient(Numbers n, Numbers d, Numbers reciprocal,
                                             AnyMost* most) {
  constexpr double kUnit = static_cast<double>(int64_t{1} << kShift);
  const hn::DFromV<Numbers> tag;
  const hn::RebindToSigned<hn::DFromV<Numbers>> integers;
  const Numbers to_whole = hn::Set(tag, kRoundToWhole);
  const Numbers rounded = hn::MulAdd(n, hn::Mul(reciprocal, hn::Set(tag, kUnit)), to_whole);
  const Numbers quotient = most->of(hn::Sub(rounded, to_whole));
  const Numbers remainder = hn::NegMulAdd(quotient, hn::Mul(d, hn::Set(tag, 1 / kUnit)), n);
  const auto whole = hn::Sub(hn::BitCast(integers, rounded), hn::BitCast(integers, to_whole));
  const auto is_above = hn::Lt(remainder, hn::Zero(tag));
  return hn::Add(whole, hn::BitCast(integers, hn::VecFromMask(tag, is_above)));
}

}  // namespace
}  // namespace selvage::mapper::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
