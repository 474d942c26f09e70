// From lanes of either map to places in the texture. Included once for each SIMD target.
#if defined(SELVAGE_VECTOR_LANES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SELVAGE_VECTOR_LANES_INL_H
#undef SELVAGE_VECTOR_LANES_INL_H
#else
#define SELVAGE_VECTOR_LANES_INL_H
#endif

#include <bit>

#include "mapper/vector/near_ties-inl.h"
#include "mapper/vector/window-inl.h"

HWY_BEFORE_NAMESPACE();
namespace selvage::mapper::HWY_NAMESPACE {
namespace {

inline constexpr int kAnchorShift = kLaneFraction - kTexelFraction;

[[nodiscard]] HWY_INLINE int32_t floor_fx16(int64_t lane_fx32) {
  return static_cast<int32_t>(lane_fx32 >> kAnchorShift);
}

[[nodiscard]] HWY_INLINE int32_t floor_texel(int64_t lane_fx32) {
  return static_cast<int32_t>(lane_fx32 >> kLaneFraction);
}

// As RowOfTies and PlaneTies ask for them, of lanes that lack less.
[[nodiscard]] HWY_INLINE int spare_bits_fx16(int32_t lack_fx16) {
  return kTexelFraction - std::bit_width(static_cast<uint32_t>(lack_fx16));
}

// The same of lanes of 32.32, or of what is as near.
[[nodiscard]] HWY_INLINE int spare_bits_fx32(uint32_t margin_fx32) {
  return kLaneFraction - std::bit_width(margin_fx32);
}

// Of 16.16 lanes that come from 32.32 ones.
[[nodiscard]] HWY_INLINE int32_t lack_fx16(uint32_t margin_fx32) {
  return kVectorTruncations_fx16 + static_cast<int32_t>(margin_fx32 >> kAnchorShift) + 1;
}

// kLanes lanes of both coordinates, 16.16 modulo 2^32.
struct LaneVectors {
  V32 u, v;
};

struct TexelVectors {
  V32 s, t;
};

// Lanes, 16.16 modulo 2^32, whose true values are below them + lack_fx16.
class LowLanes {
 public:
  static constexpr int kFraction = kTexelFraction;

  explicit HWY_INLINE LowLanes(int32_t lack_fx16) : lack_fx16_(lack_fx16) {}

  // What adding all that they may lack changes in either lane: above the low 16 bits, texels.
  [[nodiscard]] HWY_INLINE V32 changes(const LaneVectors& lanes) const {
    return hn::Or(change(lanes.u), change(lanes.v));
  }
  [[nodiscard]] HWY_INLINE bool any_near(const LaneVectors& lanes) const {
    return any_bits(changes(lanes), ~0xFFFF);
  }

  [[nodiscard]] HWY_INLINE int32_t lack_fx16() const { return lack_fx16_; }
  [[nodiscard]] HWY_INLINE int spare_bits() const { return spare_bits_fx16(lack_fx16_); }

  // Texels, near-ties and all. The lanes are those of pixels from `first` on, as `ties` counts
  // them.
  template <class Ties>
  HWY_INLINE TexelVectors decided(Ties& ties, int32_t first, const LaneVectors& lanes) const {
    TexelVectors texels{texel_of(lanes.u), texel_of(lanes.v)};
    ties.decide(first, {near(lanes.u), near(lanes.v)}, &texels.s, &texels.t);
    return texels;
  }

 protected:
  static HWY_INLINE V32 texel_of(V32 lane_fx16) {
    return hn::ShiftRight<kTexelFraction>(lane_fx16);
  }

 private:
  HWY_INLINE V32 change(V32 lane_fx16) const {
    return hn::Xor(hn::Add(lane_fx16, hn::Set(D32(), lack_fx16_)), lane_fx16);
  }
  HWY_INLINE hn::Mask<D32> near(V32 lane_fx16) const {
    return hn::Ne(texel_of(change(lane_fx16)), hn::Zero(D32()));
  }

  int32_t lack_fx16_;
};

// Lanes raised by all that they lacked, less than a texel: a true value is below them, by lack_fx16
// at most. Where a fraction is not less than that, both have one floor.
class RaisedLanes {
 public:
  explicit HWY_INLINE RaisedLanes(int32_t lack_fx16)
      : lack_(hn::BitCast(Halves(), hn::Set(D32(), lack_fx16))) {}

  [[nodiscard]] HWY_INLINE bool any_near(const LaneVectors& raised) const {
    const Halves d;  // fractions, and texels: of these none is below 0, the lack's upper half
    const auto least = hn::Min(hn::BitCast(d, raised.u), hn::BitCast(d, raised.v));
    return !hn::AllFalse(d, hn::Lt(least, lack_));
  }
  [[nodiscard]] HWY_INLINE bool any_near(const LaneVectors& one, const LaneVectors& other) const {
    const Halves d;
    const auto least = hn::Min(hn::Min(hn::BitCast(d, one.u), hn::BitCast(d, one.v)),
                               hn::Min(hn::BitCast(d, other.u), hn::BitCast(d, other.v)));
    return !hn::AllFalse(d, hn::Lt(least, lack_));
  }

 private:
  using Halves = hn::Repartition<uint16_t, D32>;

  hn::Vec<Halves> lack_;
};

// From lanes to places in the texture.
template <class Address>
class FixedLanes : public LowLanes {
 public:
  HWY_INLINE FixedLanes(const selvage_texture& texture, int32_t lack_fx16)
      : LowLanes(lack_fx16), extent_(extent_of(texture)) {}

  // Places in the texture, in texels from its first; those of lanes that mean nothing are valid
  // too.
  HWY_INLINE V32 places(const LaneVectors& lanes) const {
    return Address::place(texel_of(lanes.u), texel_of(lanes.v), extent_);
  }

  // Texels of a window of so many rows by lanes that are counted from its origin. Those of no pixel
  // may lie anywhere.
  template <int kColumnBits, int kFractionOfLanes = kFraction>
  static HWY_INLINE V32 window_index(const LaneVectors& lanes, int32_t rows) {
    const D32 d;
    const V32 s_of_lane = hn::ShiftRight<kFractionOfLanes>(lanes.u);
    if constexpr (Address::kClampsWindows) {
      const V32 s = Address::window_texel(s_of_lane, kColumns<kColumnBits>);
      const V32 t = Address::window_texel(hn::ShiftRight<kFractionOfLanes>(lanes.v), rows);
      return hn::Add(hn::ShiftLeft<kColumnBits>(t), s);
    } else {
      return hn::OrAnd(s_of_lane, rows_of_lane<kFractionOfLanes - kColumnBits>(lanes.v),
                       hn::Set(d, -kColumns<kColumnBits>));
    }
  }

 private:
  template <int kRightBits>
  static HWY_INLINE V32 rows_of_lane(V32 lane) {
    if constexpr (kRightBits < 0) {
      return hn::ShiftLeft<-kRightBits>(lane);
    } else {
      return hn::ShiftRight<kRightBits>(lane);
    }
  }

  Extent extent_;
};

}  // namespace
}  // namespace selvage::mapper::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
