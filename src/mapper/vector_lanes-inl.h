// From lanes of either map to places in the texture. Included once for each SIMD target.
#if defined(SELVAGE_VECTOR_LANES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SELVAGE_VECTOR_LANES_INL_H
#undef SELVAGE_VECTOR_LANES_INL_H
#else
#define SELVAGE_VECTOR_LANES_INL_H
#endif

#include <array>
#include <bit>

#include "mapper/vector_near_ties-inl.h"
#include "mapper/vector_store-inl.h"
#include "mapper/vector_window-inl.h"

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

// Of 16.16 lanes that come from 32.32 ones.
[[nodiscard]] HWY_INLINE int32_t lack_fx16(uint32_t margin_fx32) {
  return kVectorTruncations_fx16 + static_cast<int32_t>(margin_fx32 >> kAnchorShift) + 1;
}

// kLanes lanes of both coordinates, 16.16 modulo 2^32.
struct LaneVectors {
  V32 u, v;
};

// A window for a vector by its lanes: the least texels, and its rows, 0 where there is none. What
// near-ties are raised to may lie beyond it.
struct LowWindow {
  int32_t s, t, rows;
};

struct TexelVectors {
  V32 s, t;
};

// From lanes to places in the texture.
template <class Address>
class FixedLanes {
 public:
  static constexpr int kFraction = kTexelFraction;

  // A true value is below its lane + lack_fx16.
  HWY_INLINE FixedLanes(const selvage_texture& texture, int32_t lack_fx16)
      : extent_(extent_of(texture)), lack_fx16_(lack_fx16) {}

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
      return hn::OrAnd(s_of_lane, hn::ShiftRight<kFractionOfLanes - kColumnBits>(lanes.v),
                       hn::Set(d, -kColumns<kColumnBits>));
    }
  }

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

  // The same, drawn.
  template <class Pixel, class Ties>
  HWY_INLINE void draw(const Span& rest, const Surface& surface, Ties& ties,
                       const LaneVectors& lanes, const LowWindow& low) const {
    draw_texels<Pixel>(rest, surface, decided(ties, rest.left_px - ties.span().left_px, lanes),
                       low);
  }

  // A vector of right texels, or what there is left of one at a row's end: from a window, or, where
  // there is none, by a load for each pixel.
  template <class Pixel>
  HWY_INLINE void draw_texels(const Span& rest, const Surface& surface, const TexelVectors& texels,
                              const LowWindow& low) const {
    const auto* const from = static_cast<const Pixel*>(surface.texture.texels);
    char* const to = first_pixel(surface, rest);
    if (kHasWindows && low.rows != 0 &&
        draw_window(texels, low, from, rest.width_px(), reinterpret_cast<Pixel*>(to))) {
      return;
    }
    HWY_ALIGN int32_t place[kLanes];
    hn::Store(Address::place(texels.s, texels.t, extent_), D32(), place);
    fetch_vector<Pixel>(from, place, rest.width_px(), to);
  }

 private:
  static HWY_INLINE V32 texel_of(V32 lane_fx16) {
    return hn::ShiftRight<kTexelFraction>(lane_fx16);
  }
  HWY_INLINE V32 change(V32 lane_fx16) const {
    return hn::Xor(hn::Add(lane_fx16, hn::Set(D32(), lack_fx16_)), lane_fx16);
  }
  HWY_INLINE hn::Mask<D32> near(V32 lane_fx16) const {
    return hn::Ne(texel_of(change(lane_fx16)), hn::Zero(D32()));
  }

  // False where the window does not hold them.
  template <class Pixel>
  HWY_INLINE bool draw_window(const TexelVectors& texels, const LowWindow& low, const Pixel* from,
                              int32_t count_px, Pixel* to) const {
    const D32 d;
    const int32_t last_column = extent_.width_texel - kLanes;
    const int32_t last_row = extent_.height_texel - low.rows;
    const Origin s = Address::origin(low.s, last_column, extent_.width_texel);
    const Origin t = Address::origin(low.t, last_row, extent_.height_texel);
    const V32 column =
        hn::Sub(Address::window_texel(texels.s, extent_.width_texel), hn::Set(d, s.texel));
    const V32 row =
        hn::Sub(Address::window_texel(texels.t, extent_.height_texel), hn::Set(d, t.texel));
    const auto beyond =
        hn::Or(hn::Gt(column, hn::Set(d, kLanes - 1)), hn::Gt(row, hn::Set(d, low.rows - 1)));
    if (s.index > last_column || t.index > last_row || !hn::AllFalse(d, beyond)) return false;
    const Pixel* const window = from + t.index * ptrdiff_t{extent_.pitch_texel} + s.index;
    store_pixels(pick<kWindowColumnBits>(window, extent_.pitch_texel, low.rows,
                                         hn::Add(hn::ShiftLeft<kWindowColumnBits>(row), column)),
                 count_px, to);
    return true;
  }

  Extent extent_;
  int32_t lack_fx16_;
};

// Vectors of pixels that a hot loop leaves to others, so that it has no calls and keeps all it
// needs in registers: what is left of their span from there on.
struct Left {
  static constexpr int32_t kMost = 64;
  int32_t count = 0;
  std::array<Span, kMost> rest;
};

}  // namespace
}  // namespace selvage::mapper::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
