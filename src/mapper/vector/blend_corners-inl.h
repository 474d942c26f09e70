// The mean of four texels, each corner's in a vector of its own. Included once for each SIMD
// target.
//
// By AVX-512 it is the formula of vector/blend_mix-inl.h with a weight w of 0 made 1, where the
// right texel must be the left one. So weights w and 256 - w fit bytes, and of levels less 128 a
// sum across 16 bits. Elsewhere it is that formula itself.
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

// The texels around a vector of pixels, as in_corners() has them.
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
        rows_of_8(kept_in_register(~7U)),
        rows_of_16(kept_in_register(~15U)),
        to_right(kept_in_register(0xFF << kWindowGridFraction)),
        odd_pair(kept_in_register(2 * kLanes)),
        last_pairs(kept_in_register(4 * kLanes)),
        byte_ones(kept_in_register(0x01010101)),
        even_bytes(kept_in_register(0x00FF00FF)),
        even_ones(kept_in_register(0x00010001)),
        odd_bytes(kept_in_register(0xFF00FF00)),
        byte_shift(kept_in_register(0x01000100)) {}

  V32 signs, rows_of_8, rows_of_16, to_right, odd_pair, last_pairs, byte_ones, even_bytes,
      even_ones, odd_bytes, byte_shift;
};

#if HWY_TARGET == HWY_AVX3

// Less 128 in each channel.
[[nodiscard]] HWY_INLINE V32 in_corners(V32 texels, const BlendConstants& k) {
  return hn::Xor(texels, k.signs);
}

// The third byte of each lane, where weights are: four times; as the high bytes of two words.
HWY_ALIGN inline constexpr uint8_t kWeightBytes[16] = {2,  2,  2,  2,  6,  6,  6,  6,
                                                       10, 10, 10, 10, 14, 14, 14, 14};
HWY_ALIGN inline constexpr uint8_t kWeightWords[16] = {0x80, 2,  0x80, 2,  0x80, 6,  0x80, 6,
                                                       0x80, 10, 0x80, 10, 0x80, 14, 0x80, 14};

// 256 - w and w, twice each. A weight of 0 counts as 1: the right texel is the left one then.
[[nodiscard]] HWY_INLINE V32 weights_across(V32 u, const BlendConstants& k) {
  const hn::Repartition<uint8_t, D32> d8;
  const auto w = hn::Max(hn::BitCast(d8, reorder(u, kWeightBytes)), hn::BitCast(d8, k.byte_ones));
  const auto flipped = hn::Xor(w, hn::BitCast(d8, k.even_bytes));  // 255 - w and w
  return hn::BitCast(D32(), hn::Add(flipped, hn::BitCast(d8, k.even_ones)));
}

// (256 - w) left + w right - 2^15 of each channel: 16 bits. Channels 0 and 2 are even, 1 and 3 odd.
struct Across {
  V16 even, odd;
};

// Bytes are shifted by products: shifts compete with permutes.
[[nodiscard]] HWY_INLINE Across across(V32 left, V32 right, V32 weights, const BlendConstants& k) {
  const D32 d;
  const hn::RebindToUnsigned<D16> d16;
  const auto byte_shift = hn::BitCast(d16, k.byte_shift);
  const auto up = hn::Mul(hn::BitCast(d16, right), byte_shift);
  const auto down = hn::MulHigh(hn::BitCast(d16, left), byte_shift);
  return {byte_products(weights, hn::IfVecThenElse(k.even_bytes, left, hn::BitCast(d, up))),
          byte_products(weights, hn::IfVecThenElse(k.even_bytes, hn::BitCast(d, down), right))};
}

[[nodiscard]] HWY_INLINE V32 mix_corners(const Corners& of, const WindowLanes& lanes,
                                         const BlendConstants& k) {
  const V32 w = weights_across(lanes.u, k);
  const V16 z = spread(lanes.v, kWeightWords);
  const V16 start = hn::BitCast(D16(), k.signs);  // 2^15, which the sums across are less, and 128
  const Across upper = across(of.upper_left, of.upper_right, w, k);
  const Across lower = across(of.lower_left, of.lower_right, w, k);
  const V16 even = mix_down(start, upper.even, lower.even, z);
  const V16 odd = mix_down(start, upper.odd, lower.odd, z);
  return high_bytes(even, odd, k.odd_bytes);
}

#else

[[nodiscard]] HWY_INLINE V32 in_corners(V32 texels, const BlendConstants& /*k*/) { return texels; }

// Channels of left texels beside those of right ones.
[[nodiscard]] HWY_INLINE Pairs side_by_side(V32 left, V32 right) {
  const D32 d;
  const hn::Repartition<uint8_t, D32> d8;
  const auto a = hn::BitCast(d8, left), b = hn::BitCast(d8, right);
  return {hn::BitCast(d, hn::InterleaveLower(d8, a, b)),
          hn::BitCast(d, hn::InterleaveUpper(d8, a, b))};
}

[[nodiscard]] HWY_INLINE V32 mix_corners(const Corners& of, const WindowLanes& lanes,
                                         const BlendConstants& /*k*/) {
  return mix(
      {side_by_side(of.upper_left, of.upper_right), side_by_side(of.lower_left, of.lower_right)},
      hn::ShiftRight<kWindowGridFraction>(lanes.u), hn::ShiftRight<kWindowGridFraction>(lanes.v));
}

#endif

}  // namespace
}  // namespace selvage::mapper::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
