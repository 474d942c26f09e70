// From lanes of either map to places in the texture. Included once for each SIMD target.
#if defined(SELVAGE_VECTOR_LANES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SELVAGE_VECTOR_LANES_INL_H
#undef SELVAGE_VECTOR_LANES_INL_H
#else
#define SELVAGE_VECTOR_LANES_INL_H
#endif

#include "mapper/vector_kernel-inl.h"
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
  HWY_INLINE FixedLanes(const ExactMap& exact, const selvage_texture& texture, int32_t lack_fx16)
      : exact_(exact), extent_(extent_of(texture)), lack_fx16_(lack_fx16) {}

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

  // A load for each pixel, near-ties and all.
  template <class Pixel>
  HWY_INLINE void draw(const Span& rest, const Surface& surface, const LaneVectors& lanes) const {
    HWY_ALIGN int32_t place[kLanes];
    const int32_t count = HWY_MIN(rest.width_px(), kLanes);
    hn::Store(decided_places(rest.left_px, rest.row, lanes, first_bits(count)), D32(), place);
    fetch_as<Pixel>(surface.texture.texels, place, count, first_pixel(surface, rest));
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
