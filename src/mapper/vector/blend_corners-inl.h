// The mean of four texels, each corner's in a vector of its own. Included once for each SIMD
// target.
//
// The formula of vector/blend_mix-inl.h with a weight w of 0 made 1, where the right texel must be
// the left one. So weights w and 256 - w fit bytes, and of levels less 128 a sum across 16 bits.
#if defined(SELVAGE_VECTOR_BLEND_CORNERS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SELVAGE_VECTOR_BLEND_CORNERS_INL_H
#undef SELVAGE_VECTOR_BLEND_CORNERS_INL_H
#else
#define SELVAGE_VECTOR_BLEND_CORNERS_INL_H
#endif

#include "mapper/vector/blend_mix-inl.h"

HWY_BEFORE_NAMESPACE();
namespace selvage::mapper::HWY_NAMESPACE {
namespace {

// 8.24 lanes of u - 1/2 and v - 1/2, modulo 2^32, from the first texel of a window on. Their
// weights are a byte.
struct WindowLanes {
  V32 u, v;
};
inline constexpr int kWindowGridFraction = kWindowFraction - kGridBits;
static_assert(kWindowGridFraction == 16 && kGridBits == 8, "weights are the third byte");

// The texels around a vector of pixels, each less 128 in its channels.
struct Corners {
  V32 upper_left, upper_right, lower_left, lower_right;
};

// A number in all lanes, or in parts of them, that stays in a register: what the compiler knows it
// makes anew in each turn of a loop.
[[nodiscard]] HWY_INLINE V32 kept_in_register(uint32_t number) {
  const volatile uint32_t unknown = number;
  return hn::Set(D32(), static_cast<int32_t>(unknown));
}

// What the loops need all the time.
struct BlendConstants {
  HWY_INLINE BlendConstants()
      : signs(kept_in_register(0x80808080)),
        one(kept_in_register(1)),
        weight_bits(kept_in_register(0xFF << kWindowGridFraction)),
        odd_pair(kept_in_register(2 * kLanes)),
        last_pairs(kept_in_register(4 * kLanes)),
        byte_ones(kept_in_register(0x01010101)),
        word_256(kept_in_register(0x01000100)),
        rounding(kept_in_register((1 << 23) + (1 << 15))) {}

  V32 signs, one, weight_bits, odd_pair, last_pairs, byte_ones, word_256, rounding;
};

// The third byte of each lane, where weights are: four times; as two words.
HWY_ALIGN inline constexpr uint8_t kWeightBytes[16] = {2,  2,  2,  2,  6,  6,  6,  6,
                                                       10, 10, 10, 10, 14, 14, 14, 14};
HWY_ALIGN inline constexpr uint8_t kWeightWords[16] = {2,  0x80, 2,  0x80, 6,  0x80, 6,  0x80,
                                                       10, 0x80, 10, 0x80, 14, 0x80, 14, 0x80};

// 256 - w and w, twice each. A weight of 0 counts as 1: the right texel is the left one then.
[[nodiscard]] HWY_INLINE V32 weights_across(V32 u, const BlendConstants& k) {
  const hn::Repartition<uint8_t, D32> d8;
  const auto w = hn::Max(hn::BitCast(d8, reorder(u, kWeightBytes)), hn::BitCast(d8, k.byte_ones));
  return hn::BitCast(D32(), hn::OddEven(w, hn::Sub(hn::Zero(d8), w)));
}

// 256 - z and z.
[[nodiscard]] HWY_INLINE V32 weights_down(V32 v, const BlendConstants& k) {
  const D16 d;
  const auto z = hn::BitCast(d, reorder(v, kWeightWords));
  return hn::BitCast(D32(), hn::OddEven(z, hn::Sub(hn::BitCast(d, k.word_256), z)));
}

// Of the first two pixels of each block, or of the last two.
template <bool kLast, class D>
[[nodiscard]] HWY_INLINE hn::Vec<D> side_by_side(D d, hn::Vec<D> a, hn::Vec<D> b) {
  if constexpr (kLast) {
    return hn::InterleaveUpper(d, a, b);
  } else {
    return hn::InterleaveLower(d, a, b);
  }
}

// (256 - w) left + w right - 2^15 of each channel of those pixels: 16 bits.
template <bool kLast>
[[nodiscard]] HWY_INLINE V16 across(V32 left, V32 right, V32 weights) {
  const D32 d;
  const hn::Repartition<uint8_t, D32> d8;
  const auto levels = side_by_side<kLast>(d8, hn::BitCast(d8, left), hn::BitCast(d8, right));
  return byte_products(side_by_side<kLast>(d, weights, weights), hn::BitCast(d, levels));
}

// S + 2^15 of each channel of pixel kPixel of each block. S of those sums is less by 2^23.
template <int kPixel>
[[nodiscard]] HWY_INLINE V32 down(V16 upper, V16 lower, V32 weights, const BlendConstants& k) {
  const D16 d;
  return hn::Add(k.rounding, word_products(side_by_side<kPixel % 2 != 0>(d, upper, lower),
                                           hn::BitCast(d, hn::Broadcast<kPixel>(weights))));
}

// Bits 16 to 23 of four pixels of each block, to bytes.
[[nodiscard]] HWY_INLINE V32 high_words(V32 first, V32 second, V32 third, V32 fourth) {
#if HWY_TARGET == HWY_AVX3
  HWY_ALIGN static constexpr uint16_t kOrder[32] = {1,  3,  5,  7,  33, 35, 37, 39, 9,  11, 13,
                                                    15, 41, 43, 45, 47, 17, 19, 21, 23, 49, 51,
                                                    53, 55, 25, 27, 29, 31, 57, 59, 61, 63};
  const __m512i order = _mm512_load_si512(kOrder);
  return V32{_mm512_packus_epi16(_mm512_permutex2var_epi16(first.raw, order, second.raw),
                                 _mm512_permutex2var_epi16(third.raw, order, fourth.raw))};
#else
  static_cast<void>(second);
  static_cast<void>(third);
  static_cast<void>(fourth);
  return first;
#endif
}

[[nodiscard]] HWY_INLINE V32 mix_corners(const Corners& of, const WindowLanes& lanes,
                                         const BlendConstants& k) {
  const V32 w = weights_across(lanes.u, k), z = weights_down(lanes.v, k);
  const V16 upper_first = across<false>(of.upper_left, of.upper_right, w);
  const V16 lower_first = across<false>(of.lower_left, of.lower_right, w);
  const V16 upper_last = across<true>(of.upper_left, of.upper_right, w);
  const V16 lower_last = across<true>(of.lower_left, of.lower_right, w);
  return high_words(down<0>(upper_first, lower_first, z, k),
                    down<1>(upper_first, lower_first, z, k), down<2>(upper_last, lower_last, z, k),
                    down<3>(upper_last, lower_last, z, k));
}

}  // namespace
}  // namespace selvage::mapper::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
