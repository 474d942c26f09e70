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
// The same as the high bytes of words, 4 times each: 256 times the number.
HWY_ALIGN inline constexpr uint8_t kWordsFirst[16] = {0x80, 0, 0x80, 0, 0x80, 0, 0x80, 0,
                                                      0x80, 4, 0x80, 4, 0x80, 4, 0x80, 4};
HWY_ALIGN inline constexpr uint8_t kWordsLast[16] = {0x80, 8,  0x80, 8,  0x80, 8,  0x80, 8,
                                                     0x80, 12, 0x80, 12, 0x80, 12, 0x80, 12};
// Channels of the first two pixels, each before one of the last two, to pixels.
HWY_ALIGN inline constexpr uint8_t kFirstThenLast[16] = {0, 2, 4, 6, 8, 10, 12, 14,
                                                         1, 3, 5, 7, 9, 11, 13, 15};

// Bytes of each block spread over words: 0 where the order is 0x80.
[[nodiscard]] HWY_INLINE V16 spread(V32 bytes, const uint8_t* order) {
  const hn::Repartition<uint8_t, D32> d8;
  return hn::BitCast(D16(),
                     hn::TableLookupBytesOr0(hn::BitCast(d8, bytes), hn::LoadDup128(d8, order)));
}

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

[[nodiscard]] HWY_INLINE V16 subtract_where(hn::Mask<D16> mask, V16 from, V16 number) {
#if HWY_TARGET == HWY_AVX3
  return V16{_mm512_mask_sub_epi16(from.raw, mask.raw, from.raw, number.raw)};
#else
  return hn::Sub(from, hn::IfThenElseZero(mask, number));
#endif
}

// `start` and floor(S / 256) of each channel, less what the sums across are less, in 16 bits, of
// 256 z:
//
//     floor(S / 256) = upper + floor(z (lower - upper) / 256).
//
// The difference is modulo 2^16. Where it is negative it is 2^16 too large, and the high word of
// the product z too large by 256.
[[nodiscard]] HWY_INLINE V16 mix_down(V16 start, V16 upper, V16 lower, V16 z_fx16) {
  const D16 d;
  const hn::RebindToUnsigned<D16> du;
  const auto rise = hn::BitCast(du, hn::Sub(lower, upper));
  const V16 part = hn::BitCast(d, hn::MulHigh(rise, hn::BitCast(du, z_fx16)));
  const V16 right = subtract_where(hn::Gt(upper, lower), start, z_fx16);
  return hn::Add(hn::Add(upper, part), right);
}

// The high bytes of words, of `even` to the even bytes. `odd_bytes` has these set.
[[nodiscard]] HWY_INLINE V32 high_bytes(V16 even, V16 odd, V32 odd_bytes) {
  const D32 d;
  const hn::RebindToUnsigned<D16> du;
  const V32 low = hn::BitCast(d, hn::ShiftRight<8>(hn::BitCast(du, even)));
  return hn::OrAnd(low, hn::BitCast(d, odd), odd_bytes);
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
  const V32 flip = all_bytes(0x00FF00FF);
  const V32 w_first = hn::Xor(reorder(u_fx8, kSpreadFirst), flip);
  const V32 w_last = hn::Xor(reorder(u_fx8, kSpreadLast), flip);
  const V16 none = hn::Zero(D16());
  const V16 first = mix_down(none, mix_across(channels.upper.first, w_first),
                             mix_across(channels.lower.first, w_first), spread(v_fx8, kWordsFirst));
  const V16 last = mix_down(none, mix_across(channels.upper.last, w_last),
                            mix_across(channels.lower.last, w_last), spread(v_fx8, kWordsLast));
  const V32 pixels = reorder(high_bytes(first, last, all_bytes(0xFF00FF00)), kFirstThenLast);
  return hn::Xor(pixels, all_bytes(0x80808080));
}

}  // namespace
}  // namespace selvage::mapper::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
