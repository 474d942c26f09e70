// The mean of four texels with weights in steps of 1/256, kLanes pixels at a time. Included once
// for each SIMD target.
//
// With w of the right texels and z of the lower ones, a channel is (S + 32768) >> 16,
//
//     S = (256 - z) upper + z lower,   upper = (256 - w) a + w b,   lower = (256 - w) c + w d.
//
// Four and bilinear are one formula: (a + b + c + d + 2) >> 2 is that with all weights 1/2, for
// (2^14 (a + b + c + d) + 2^15) >> 16 is the same.
#if defined(SELVAGE_VECTOR_BLEND_MIX_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SELVAGE_VECTOR_BLEND_MIX_INL_H
#undef SELVAGE_VECTOR_BLEND_MIX_INL_H
#else
#define SELVAGE_VECTOR_BLEND_MIX_INL_H
#endif

#include "mapper/filter_point.h"
#include "mapper/vector/blend_pairs-inl.h"
#include "mapper/vector/words-inl.h"

HWY_BEFORE_NAMESPACE();
namespace selvage::mapper::HWY_NAMESPACE {
namespace {

using D16 = hn::Repartition<int16_t, D32>;
using V16 = hn::Vec<D16>;

[[nodiscard]] HWY_INLINE V32 all_bytes(uint32_t four) {
  return hn::Set(D32(), static_cast<int32_t>(four));
}

// The bytes of each block in another order.
[[nodiscard]] HWY_INLINE V32 reorder(V32 bytes, const uint8_t* order) {
  const hn::Repartition<uint8_t, D32> d8;
  return hn::BitCast(D32(),
                     hn::TableLookupBytes(hn::BitCast(d8, bytes), hn::LoadDup128(d8, order)));
}

// The low byte of the first two of each block's numbers, 8 times each; of the last two.
HWY_ALIGN inline constexpr uint8_t kSpreadFirst[16] = {0, 0, 0, 0, 0, 0, 0, 0,
                                                       4, 4, 4, 4, 4, 4, 4, 4};
HWY_ALIGN inline constexpr uint8_t kSpreadLast[16] = {8,  8,  8,  8,  8,  8,  8,  8,
                                                      12, 12, 12, 12, 12, 12, 12, 12};
// Channels of the left texel beside those of the right one.
HWY_ALIGN inline constexpr uint8_t kInterleave[16] = {0, 4,  1, 5,  2,  6,  3,  7,
                                                      8, 12, 9, 13, 10, 14, 11, 15};
// Channels of four pixels, those of the second and third swapped, to pixels.
HWY_ALIGN inline constexpr uint8_t kTranspose[16] = {0, 4, 8, 12, 2, 6, 10, 14,
                                                     1, 5, 9, 13, 3, 7, 11, 15};

// Of neighbouring bytes, unsigned weights and signed levels. No sum may leave 16 bits.
[[nodiscard]] HWY_INLINE V16 byte_products(V32 weights, V32 levels) {
#if HWY_TARGET == HWY_SSE4
  return V16{_mm_maddubs_epi16(weights.raw, levels.raw)};
#elif HWY_TARGET == HWY_AVX2
  return V16{_mm256_maddubs_epi16(weights.raw, levels.raw)};
#elif HWY_TARGET == HWY_AVX3
  return V16{_mm512_maddubs_epi16(weights.raw, levels.raw)};
#else
  const D16 d;
  const V16 w = hn::BitCast(d, weights), level = hn::BitCast(d, levels);
  const V16 left =
      hn::Mul(hn::And(w, hn::Set(d, 0xFF)), hn::ShiftRight<8>(hn::ShiftLeft<8>(level)));
  const V16 right =
      hn::Mul(hn::And(hn::ShiftRight<8>(w), hn::Set(d, 0xFF)), hn::ShiftRight<8>(level));
  return hn::Add(left, right);
#endif
}

// (256 - w) a + w b - 2^15 + 128 of each channel, in 16 bits. With a' = a - 128 and b' likewise it
// is ((255 - w) a' + w b') + a, where weights fit bytes and sums 16 bits: [-32640, 32640].
// `weights` are 255 - w and w.
[[nodiscard]] HWY_INLINE V16 mix_across(V32 channels, V32 weights) {
  const D16 d;
  const V32 left = hn::And(channels, all_bytes(0x00FF00FF));
  const V32 centred = hn::Xor(channels, all_bytes(0x80808080));
  return hn::Add(hn::BitCast(d, left), byte_products(weights, centred));
}

// Of pixels kFirst and kFirst + 1 of each block: S + 32768 - 2^23 of each channel, for the 128
// above come to (256 - z) 128 + z 128 = 32768. Bits 16 to 23 of that, the channel less 128, go to
// the low bytes of 16 bits, of the two pixels in turn. `weights` are 256 - z and z.
template <int kFirst>
[[nodiscard]] HWY_INLINE V32 mix_down(V16 upper, V16 lower, V32 weights) {
  const D16 d;
  const auto of = [&](V32 pixel) { return hn::BitCast(d, pixel); };
  const V32 one =
      word_products(hn::InterleaveLower(d, upper, lower), of(hn::Broadcast<kFirst>(weights)));
  const V32 next =
      word_products(hn::InterleaveUpper(d, upper, lower), of(hn::Broadcast<kFirst + 1>(weights)));
  return hn::BitCast(D32(), hn::OddEven(of(next), of(hn::ShiftRight<16>(one))));
}

// Channels of the left texels beside those of the right ones.
[[nodiscard]] HWY_INLINE Around<Pairs> channels_of(const Around<Pairs>& texels) {
  const auto side_by_side = [](const Pairs& pairs) -> Pairs {
    return {reorder(pairs.first, kInterleave), reorder(pairs.last, kInterleave)};
  };
  return {side_by_side(texels.upper), side_by_side(texels.lower)};
}

// kLanes pixels of pairs whose channels are side by side; the weights are the low bytes of the
// points.
[[nodiscard]] HWY_INLINE V32 mix(const Around<Pairs>& channels, V32 u_fx8, V32 v_fx8) {
  const D32 d;
  const V32 flip = all_bytes(0x00FF00FF);
  const V32 across_first = hn::Xor(reorder(u_fx8, kSpreadFirst), flip);
  const V32 across_last = hn::Xor(reorder(u_fx8, kSpreadLast), flip);
  const V32 z = hn::And(v_fx8, hn::Set(d, kTexel_fx8 - 1));
  const V32 down = hn::Add(hn::Sub(hn::ShiftLeft<16>(z), z), hn::Set(d, kTexel_fx8));
  const V32 first = mix_down<0>(mix_across(channels.upper.first, across_first),
                                mix_across(channels.lower.first, across_first), down);
  const V32 last = mix_down<2>(mix_across(channels.upper.last, across_last),
                               mix_across(channels.lower.last, across_last), down);
  const hn::Repartition<uint8_t, D32> d8;
  const auto bytes = hn::OddEven(hn::BitCast(d8, hn::ShiftLeft<8>(last)), hn::BitCast(d8, first));
  return hn::Xor(reorder(hn::BitCast(d, bytes), kTranspose), all_bytes(0x80808080));
}

}  // namespace
}  // namespace selvage::mapper::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
