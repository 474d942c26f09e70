// From lanes of either map to places in the texture. Included once for each SIMD target.
#if defined(SELVAGE_VECTOR_LANES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SELVAGE_VECTOR_LANES_INL_H
#undef SELVAGE_VECTOR_LANES_INL_H
#else
#define SELVAGE_VECTOR_LANES_INL_H
#endif

#include "mapper/vector_near_ties-inl.h"
#include "mapper/vector_window-inl.h"

HWY_BEFORE_NAMESPACE();
namespace selvage::mapper::HWY_NAMESPACE {
namespace {

// kLanes lanes of both coordinates, 16.16 modulo 2^32.
struct LaneVectors {
  V32 u, v;
};

// From lanes to places in the texture.
template <class Address>
class FixedLanes {
 public:
  // A true value is below its lane + lack_fx16.
  HWY_INLINE FixedLanes(const selvage_texture& texture, int32_t lack_fx16)
      : extent_(extent_of(texture)), lack_fx16_(lack_fx16) {}

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

  // Places again, near-ties and all. The lanes are those of pixels from `first` on, as `ties`, of
  // a row or of packed ones, counts them.
  template <class Ties>
  HWY_NOINLINE V32 decided_places(Ties& ties, int32_t first, const LaneVectors& lanes) const {
    V32 s = texel_of(lanes.u), t = texel_of(lanes.v);
    ties.decide(first, has_near(lanes.u), has_near(lanes.v), &s, &t);
    return places_of(s, t);
  }

  // A load for each pixel, near-ties and all.
  template <class Pixel>
  HWY_INLINE void draw(const Span& rest, const Surface& surface, RowOfTies& ties,
                       const LaneVectors& lanes) const {
    HWY_ALIGN int32_t place[kLanes];
    hn::Store(decided_places(ties, rest.left_px - ties.span().left_px, lanes), D32(), place);
    fetch_as<Pixel>(surface.texture.texels, place, HWY_MIN(rest.width_px(), kLanes),
                    first_pixel(surface, rest));
  }

 private:
  static HWY_INLINE V32 texel_of(V32 lane_fx16) {
    return hn::ShiftRight<kTexelFraction>(lane_fx16);
  }
  HWY_INLINE V32 change(V32 lane_fx16) const {
    return hn::Xor(hn::Add(lane_fx16, hn::Set(D32(), lack_fx16_)), lane_fx16);
  }
  HWY_INLINE bool has_near(V32 lane_fx16) const { return any_bits(change(lane_fx16), ~0xFFFF); }
  HWY_INLINE V32 places_of(V32 s, V32 t) const { return Address::place(s, t, extent_); }

  Extent extent_;
  int32_t lack_fx16_;
};

// Vectors of pixels that a hot loop leaves to others, so that it has no calls and keeps all it
// needs in registers: what is left of their span from there on.
struct Left {
  static constexpr int32_t kMost = 64;
  int32_t count = 0;
  Span rest[kMost];
};

}  // namespace
}  // namespace selvage::mapper::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
