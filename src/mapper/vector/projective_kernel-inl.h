// Projective spans by vectors of doubles. Included once for each SIMD target.
//
// The same numerators, denominators and bound as DividedLanes: u lies in (estimate - error,
// estimate + error), so where both ends have one floor, that is the texel.
#if defined(SELVAGE_VECTOR_PROJECTIVE_KERNEL_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SELVAGE_VECTOR_PROJECTIVE_KERNEL_INL_H
#undef SELVAGE_VECTOR_PROJECTIVE_KERNEL_INL_H
#else
#define SELVAGE_VECTOR_PROJECTIVE_KERNEL_INL_H
#endif

#include "mapper/vector/near_ties-inl.h"

HWY_BEFORE_NAMESPACE();
namespace selvage::mapper::HWY_NAMESPACE {
namespace {

using DD = hn::CappedTag<double, kMostLanes / 2>;
using VD = hn::Vec<DD>;
using DHalf = hn::Rebind<int32_t, DD>;
inline constexpr int32_t kDoubles = static_cast<int32_t>(hn::MaxLanes(DD()));

static_assert(2 * kDoubles == kLanes);

// Of kLanes pixels: u and v lie between low and low + 1, times some scale; where near, some may
// have reached the next whole number.
struct LowTexels {
  V32 s, t;
  bool near_u, near_v;
};

inline constexpr double kUnit_texel = 1.0 / (int64_t{1} << kLaneFraction);

// What u and v of kDoubles pixels are quotients of.
struct ProjectiveParts {
  VD u, v, denominator;
};

// The floors of the two ends of where a value may be; `near` where they differ.
[[nodiscard]] HWY_INLINE hn::Vec<DHalf> low_texel(VD estimate, double error, bool* near) {
  const DD d;
  const VD floor = hn::Floor(hn::Sub(estimate, hn::Set(d, error)));
  *near |= !hn::AllFalse(d, hn::Ne(floor, hn::Floor(hn::Add(estimate, hn::Set(d, error)))));
  return hn::DemoteTo(DHalf(), floor);
}

[[nodiscard]] HWY_INLINE V32 low_texel(VD first, VD second, double error, bool* near) {
  const auto low = low_texel(first, error, near);
  return hn::Combine(D32(), low_texel(second, error, near), low);
}

[[nodiscard]] HWY_INLINE LowTexels low_texels(const ProjectiveParts& first,
                                              const ProjectiveParts& second, double error) {
  const VD one = hn::Set(DD(), 1.0);
  const VD w = hn::Div(one, first.denominator), next_w = hn::Div(one, second.denominator);
  LowTexels low{{}, {}, false, false};
  low.s = low_texel(hn::Mul(first.u, w), hn::Mul(second.u, next_w), error, &low.near_u);
  low.t = low_texel(hn::Mul(first.v, w), hn::Mul(second.v, next_w), error, &low.near_v);
  return low;
}

// Numbers are in texels times `scale`, a power of two.
class ProjectiveRow {
 public:
  HWY_INLINE ProjectiveRow(const DividedLanes& lanes, double scale)
      : u_(scaled(lanes.u_numerator_fx32(), scale * kUnit_texel)),
        v_(scaled(lanes.v_numerator_fx32(), scale * kUnit_texel)),
        denominator_(lanes.denominator()),
        error_(static_cast<double>(lanes.error_fx32()) * (scale * kUnit_texel)) {}

  // Of the pixels from an offset in the span on.
  HWY_INLINE LowTexels low(int32_t offset_px) const {
    return low_texels(parts(offset_px), parts(offset_px + kDoubles), error_);
  }
  // Which of them may have reached the next whole number: where the floor of the upper end, that
  // of an error below 0, is another.
  HWY_INLINE NearTies near(int32_t offset_px, const LowTexels& low) const {
    const LowTexels high = low_texels(parts(offset_px), parts(offset_px + kDoubles), -error_);
    return {hn::Ne(high.s, low.s), hn::Ne(high.t, low.t)};
  }

 private:
  using Linear = DividedLanes::Linear;
  static Linear scaled(const Linear& fx32, double factor) {
    return {fx32.start * factor, fx32.step * factor};
  }
  HWY_INLINE ProjectiveParts parts(int32_t offset_px) const {
    const DD d;
    const VD i = hn::Add(hn::Iota(d, 0.0), hn::Set(d, static_cast<double>(offset_px)));
    return {at(u_, i), at(v_, i), at(denominator_, i)};
  }
  static HWY_INLINE VD at(const Linear& line, VD i) {
    const DD d;
    return hn::MulAdd(i, hn::Set(d, line.step), hn::Set(d, line.start));
  }

  Linear u_, v_, denominator_;
  double error_;
};

}  // namespace
}  // namespace selvage::mapper::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
