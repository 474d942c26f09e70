// Affine lanes by vectors. Included once for each SIMD target.
//
// Lanes are 16.16 (fx16), 32 bits wide: an anchor, the floor of the least 32.32 lane of a vector's
// pixels, and the floors of the steps from there. So
//
//     lane <= true value < lane + kVectorTruncations_fx16 + margin     (spec/proofs/vector_lanes.g)
//
// modulo 2^32, and a lane whose fraction is not within so much of 1 shows the texel.
#if defined(SELVAGE_VECTOR_AFFINE_LANES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SELVAGE_VECTOR_AFFINE_LANES_INL_H
#undef SELVAGE_VECTOR_AFFINE_LANES_INL_H
#else
#define SELVAGE_VECTOR_AFFINE_LANES_INL_H
#endif

#include "mapper/vector/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace selvage::mapper::HWY_NAMESPACE {
namespace {

// The lane of a vector that has the least value, and from which the others are counted.
[[nodiscard]] HWY_INLINE int32_t anchor_lane(int64_t step_fx32) {
  return step_fx32 < 0 ? kLanes - 1 : 0;
}

// floor(from + i step) for lane i counted from the anchor, in units of 2^kShift fx32: whole units,
// and what the fractions add. `from` is not negative.
template <int kShift>
[[nodiscard]] HWY_INLINE V32 offsets_from_anchor(int64_t step_fx32, int64_t from_fx32 = 0) {
  const D32 d;
  const V32 i = hn::Abs(hn::Sub(hn::Iota(d, 0), hn::Set(d, anchor_lane(step_fx32))));
  const int64_t rise_fx32 = magnitude_fx32(step_fx32);
  const auto whole = [](int64_t x_fx32) { return static_cast<int32_t>(x_fx32 >> kShift); };
  const auto below = [](int64_t x_fx32) {
    return static_cast<int32_t>(x_fx32 & ((1 << kShift) - 1));
  };
  const auto line = [&](int32_t from, int32_t step) HWY_ATTR {
    return hn::Add(hn::Set(d, from), hn::Mul(i, hn::Set(d, step)));
  };
  return hn::Add(line(whole(from_fx32), whole(rise_fx32)),
                 hn::ShiftRight<kShift>(line(below(from_fx32), below(rise_fx32))));
}

// Modulo 2^64.
[[nodiscard]] HWY_INLINE Lane plus(Lane lane, int32_t steps, Lane step) {
  const auto sum = [steps](int64_t from, int64_t by) {
    return static_cast<int64_t>(static_cast<uint64_t>(from) +
                                static_cast<uint64_t>(steps) * static_cast<uint64_t>(by));
  };
  return {sum(lane.u_fx32, step.u_fx32), sum(lane.v_fx32, step.v_fx32)};
}

// kLanes lanes of 32.32, in two vectors.
struct WideLanes {
  V32 low, high;

  [[nodiscard]] HWY_INLINE V32 texels() const { return hn::ConcatOdd(D32(), high, low); }
  [[nodiscard]] HWY_INLINE V32 fractions_fx16() const {
    return unsigned_shift(hn::ConcatEven(D32(), high, low));
  }
  // Modulo 2^32.
  [[nodiscard]] HWY_INLINE V32 floors_fx16() const { return floors<kAnchorShift>(); }
  // The same in units of 2^kShift fx32.
  template <int kShift>
  [[nodiscard]] HWY_INLINE V32 floors() const {
    const auto shifted = [](V32 half) HWY_ATTR {
      const hn::Repartition<uint64_t, D32> wide;
      return hn::BitCast(D32(), hn::ShiftRight<kShift>(hn::BitCast(wide, half)));
    };
    return hn::ConcatEven(D32(), shifted(high), shifted(low));
  }

 private:
  static HWY_INLINE V32 unsigned_shift(V32 lanes) {
    const hn::RebindToUnsigned<D32> d;
    return hn::BitCast(D32(), hn::ShiftRight<kAnchorShift>(hn::BitCast(d, lanes)));
  }
};

// From the 32.32 lane of a vector's first pixel to the least one.
[[nodiscard]] HWY_INLINE Lane way_to_anchor(Lane step_x) {
  return {anchor_lane(step_x.u_fx32) * step_x.u_fx32, anchor_lane(step_x.v_fx32) * step_x.v_fx32};
}

template <class Address>
class AffineBatch : public FixedLanes<Address> {
 public:
  HWY_INLINE AffineBatch(const AffineSpans& spans, const Surface& surface)
      : FixedLanes<Address>(surface.texture, lack_fx16(spans.field.margin_fx32)),
        to_anchor_(way_to_anchor(spans.field.step_x)),
        offset_u_(offsets_from_anchor<kAnchorShift>(spans.field.step_x.u_fx32)),
        offset_v_(offsets_from_anchor<kAnchorShift>(spans.field.step_x.v_fx32)) {}

  // From the 32.32 lane of a vector's first pixel to the least one.
  [[nodiscard]] HWY_INLINE Lane to_anchor() const { return to_anchor_; }
  // Modulo 2^64, as lanes are where nobody asks for them.
  HWY_INLINE Lane anchor(Lane first) const { return plus(first, 1, to_anchor_); }
  HWY_INLINE LaneVectors lanes_from(Lane anchor) const {
    return lanes_from(floor_fx16(anchor.u_fx32), floor_fx16(anchor.v_fx32));
  }
  HWY_INLINE LaneVectors lanes_from(int32_t u_fx16, int32_t v_fx16) const {
    const D32 d;
    return {hn::Add(hn::Set(d, u_fx16), offset_u_), hn::Add(hn::Set(d, v_fx16), offset_v_)};
  }
  // From the lane of a vector that has the least value.
  [[nodiscard]] HWY_INLINE LaneVectors offsets() const { return {offset_u_, offset_v_}; }

 private:
  Lane to_anchor_;
  V32 offset_u_, offset_v_;
};

}  // namespace
}  // namespace selvage::mapper::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
