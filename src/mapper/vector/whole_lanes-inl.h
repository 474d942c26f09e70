// Affine lanes of 32.32, nothing of them left out, for pixels that are near-ties for lanes
// of 16.16: few are for these. Included once for each SIMD target.
#if defined(SELVAGE_VECTOR_WHOLE_LANES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SELVAGE_VECTOR_WHOLE_LANES_INL_H
#undef SELVAGE_VECTOR_WHOLE_LANES_INL_H
#else
#define SELVAGE_VECTOR_WHOLE_LANES_INL_H
#endif

#include "mapper/vector/affine_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace selvage::mapper::HWY_NAMESPACE {
namespace {

// The floors of lanes, and which of them what lanes lack may raise.
struct WholeTexels : TexelVectors {
  NearTies near;
};

// 32.32 lanes of kLanes pixels of a row.
class WholeLanes {
 public:
  HWY_INLINE WholeLanes(Lane step, uint32_t margin_fx32)
      : u_(walk(step.u_fx32)), v_(walk(step.v_fx32)), margin_fx32_(margin_fx32) {}

  // From the lane of a vector's first pixel on.
  [[nodiscard]] HWY_INLINE WholeTexels from(Lane first) const {
    const WideLanes u = sum(u_, first.u_fx32), v = sum(v_, first.v_fx32);
    return {{u.texels(), v.texels()}, {near(u), near(v)}};
  }

 private:
  using DWide = hn::Repartition<uint64_t, D32>;
  using DUnsigned = hn::RebindToUnsigned<D32>;

  // i steps for lane i, modulo 2^64.
  static HWY_INLINE WideLanes walk(int64_t step_fx32) {
    constexpr uint64_t kHalf = kLanes / 2;
    return {walk_from(step_fx32, 0), walk_from(step_fx32, kHalf)};
  }
  static HWY_INLINE V32 walk_from(int64_t step_fx32, uint64_t first) {
    const DUnsigned d;
    const auto step = static_cast<uint64_t>(step_fx32);
    const auto i = hn::BitCast(d, hn::Iota(DWide(), first));
    const auto by_low = hn::MulEven(i, hn::Set(d, static_cast<uint32_t>(step)));
    const auto by_high = hn::MulEven(i, hn::Set(d, static_cast<uint32_t>(step >> 32)));
    return hn::BitCast(D32(), hn::Add(by_low, hn::ShiftLeft<32>(by_high)));
  }
  static HWY_INLINE WideLanes sum(const WideLanes& lanes, int64_t first_fx32) {
    const DWide d;
    const auto first = hn::Set(d, static_cast<uint64_t>(first_fx32));
    const auto plus_first = [&](V32 half) HWY_ATTR {
      return hn::BitCast(D32(), hn::Add(hn::BitCast(d, half), first));
    };
    return {plus_first(lanes.low), plus_first(lanes.high)};
  }
  [[nodiscard]] HWY_INLINE hn::Mask<D32> near(const WideLanes& lanes) const {
    const DUnsigned d;
    const auto fraction = hn::BitCast(d, hn::ConcatEven(D32(), lanes.high, lanes.low));
    return hn::RebindMask(D32(), hn::Gt(fraction, hn::Set(d, ~margin_fx32_)));
  }

  WideLanes u_, v_;
  uint32_t margin_fx32_;
};

}  // namespace
}  // namespace selvage::mapper::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
