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

#include "mapper/vector_window-inl.h"

HWY_BEFORE_NAMESPACE();
namespace selvage::mapper::HWY_NAMESPACE {
namespace {

inline constexpr int kAnchorShift = kLaneFraction - kTexelFraction;

[[nodiscard]] HWY_INLINE int32_t floor_fx16(int64_t lane_fx32) {
  return static_cast<int32_t>(lane_fx32 >> kAnchorShift);
}

// The lane of a vector that has the least value, and from which the others are counted.
[[nodiscard]] HWY_INLINE int32_t anchor_lane(int64_t step_fx32) {
  return step_fx32 < 0 ? kLanes - 1 : 0;
}

// floor(i step) for lane i counted from the anchor: whole units, and what the fraction adds.
[[nodiscard]] HWY_INLINE V32 offsets_fx16(int64_t step_fx32) {
  const D32 d;
  const V32 i = hn::Abs(hn::Sub(hn::Iota(d, 0), hn::Set(d, anchor_lane(step_fx32))));
  const int64_t rise_fx32 = step_fx32 < 0 ? -step_fx32 : step_fx32;
  const V32 whole = hn::Mul(i, hn::Set(d, floor_fx16(rise_fx32)));
  const V32 fraction = hn::Mul(i, hn::Set(d, static_cast<int32_t>(rise_fx32 & 0xFFFF)));
  return hn::Add(whole, hn::ShiftRight<kAnchorShift>(fraction));
}

// kLanes lanes of both coordinates.
struct LaneVectors {
  V32 u, v;
};

template <class Address>
class AffineBatch {
 public:
  HWY_INLINE AffineBatch(const AffineSpans& spans, const Surface& surface)
      : exact_(spans.exact),
        extent_(extent_of(surface.texture)),
        lack_fx16_(kVectorTruncations_fx16 +
                   static_cast<int32_t>(spans.field.margin_fx32 >> kAnchorShift) + 1),
        to_anchor_{anchor_lane(spans.field.step_x.u_fx32) * spans.field.step_x.u_fx32,
                   anchor_lane(spans.field.step_x.v_fx32) * spans.field.step_x.v_fx32},
        offset_u_(offsets_fx16(spans.field.step_x.u_fx32)),
        offset_v_(offsets_fx16(spans.field.step_x.v_fx32)) {}

  // From the 32.32 lane of a vector's first pixel to the least one.
  [[nodiscard]] HWY_INLINE Lane to_anchor() const { return to_anchor_; }
  HWY_INLINE Lane anchor(Lane first) const {
    return {first.u_fx32 + to_anchor_.u_fx32, first.v_fx32 + to_anchor_.v_fx32};
  }
  HWY_INLINE LaneVectors lanes_from(Lane anchor) const {
    const D32 d;
    return {hn::Add(hn::Set(d, floor_fx16(anchor.u_fx32)), offset_u_),
            hn::Add(hn::Set(d, floor_fx16(anchor.v_fx32)), offset_v_)};
  }

  // Places in the texture, in texels from its first; those of lanes that mean nothing are valid
  // too.
  HWY_INLINE V32 places(const LaneVectors& lanes) const {
    return places_of(texel_of(lanes.u), texel_of(lanes.v));
  }

  // Texels by their distance from the origin of a window, which is given as such an index.
  HWY_INLINE V32 window_index(const LaneVectors& lanes, V32 origin) const {
    const V32 s = Address::window_texel(texel_of(lanes.u), extent_.width_texel);
    const V32 t = Address::window_texel(texel_of(lanes.v), extent_.height_texel);
    return hn::Sub(hn::Add(hn::ShiftLeft<kWindowColumnBits>(t), s), origin);
  }

  // Whether adding all that a lane may lack changes some texel.
  [[nodiscard]] HWY_INLINE bool any_near(const LaneVectors& lanes) const {
    return any_bits(hn::Or(change(lanes.u), change(lanes.v)), ~0xFFFF);
  }
  [[nodiscard]] HWY_INLINE uint32_t near_bits(V32 lane_fx16) const {
    return lane_bits(D32(), is_changed(change(lane_fx16)));
  }

  // The places of pixels that follow each other in a row, near-ties and all, where asked for.
  HWY_NOINLINE V32 decided_places(int32_t px, int32_t row, const LaneVectors& lanes,
                                  uint32_t asked) const {
    const D32 d;
    const uint32_t near_u = near_bits(lanes.u) & asked, near_v = near_bits(lanes.v) & asked;
    const ExactRow exact = exact_.row_from(px, row);
    return places_of(decide(d, texel_of(lanes.u), near_u, exact, exact.u),
                     decide(d, texel_of(lanes.v), near_v, exact, exact.v));
  }

  // The place of one pixel, near-ties or not.
  [[nodiscard]] int32_t decided_place(int32_t px, int32_t row, int32_t u_fx16,
                                      int32_t v_fx16) const {
    const ExactRow exact = exact_.row_from(px, row);
    const auto texel = [&](const ExactLine& coordinate, int32_t lane_fx16) {
      const int32_t low = lane_fx16 >> kTexelFraction;
      return (lane_fx16 & 0xFFFF) + lack_fx16_ > 0xFFFF && exact.reaches(coordinate, 0, low + 1)
                 ? low + 1
                 : low;
    };
    return Address::place_of_one(texel(exact.u, u_fx16), texel(exact.v, v_fx16), extent_);
  }

 private:
  static HWY_INLINE V32 texel_of(V32 lane_fx16) {
    return hn::ShiftRight<kTexelFraction>(lane_fx16);
  }
  HWY_INLINE V32 change(V32 lane_fx16) const {
    return hn::Xor(hn::Add(lane_fx16, hn::Set(D32(), lack_fx16_)), lane_fx16);
  }
  static HWY_INLINE hn::Mask<D32> is_changed(V32 change) {
    return hn::Ne(texel_of(change), hn::Zero(D32()));
  }
  HWY_INLINE V32 places_of(V32 s, V32 t) const { return Address::place(s, t, extent_); }

  const ExactMap& exact_;
  Extent extent_;
  int32_t lack_fx16_;
  Lane to_anchor_;
  V32 offset_u_, offset_v_;
};

}  // namespace
}  // namespace selvage::mapper::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
