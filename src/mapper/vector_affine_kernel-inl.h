// Affine spans by vectors. Included once for each SIMD target.
//
// Lanes are 16.16 (fx16), 32 bits wide: an anchor, the floor of the 32.32 lane of a vector's first
// pixel, and the floors of the steps from there. So
//
//     lane <= true value < lane + kVectorTruncations_fx16 + margin     (spec/proofs/vector_lanes.g)
//
// modulo 2^32, and a lane whose fraction is not within so much of 1 shows the texel.
#if defined(SELVAGE_VECTOR_AFFINE_KERNEL_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SELVAGE_VECTOR_AFFINE_KERNEL_INL_H
#undef SELVAGE_VECTOR_AFFINE_KERNEL_INL_H
#else
#define SELVAGE_VECTOR_AFFINE_KERNEL_INL_H
#endif

#include <algorithm>

#include "mapper/vector_kernel-inl.h"

HWY_BEFORE_NAMESPACE();
namespace selvage::mapper::HWY_NAMESPACE {
namespace {

inline constexpr int kAnchorShift = kLaneFraction - kTexelFraction;

[[nodiscard]] HWY_INLINE int32_t floor_fx16(int64_t lane_fx32) {
  return static_cast<int32_t>(lane_fx32 >> kAnchorShift);
}

// floor(i step) for lane i: the step's whole units, and what its fraction adds.
[[nodiscard]] HWY_INLINE V32 offsets_fx16(int64_t step_fx32) {
  const D32 d;
  const V32 i = hn::Iota(d, 0);
  const V32 whole = hn::Mul(i, hn::Set(d, floor_fx16(step_fx32)));
  const V32 fraction = hn::Mul(i, hn::Set(d, static_cast<int32_t>(step_fx32 & 0xFFFF)));
  return hn::Add(whole, hn::ShiftRight<kAnchorShift>(fraction));
}

[[nodiscard]] HWY_INLINE int32_t floor_texel(int64_t lane_fx32) {
  return static_cast<int32_t>(lane_fx32 >> kLaneFraction);
}

using D64 = hn::Repartition<uint64_t, D32>;
using V64 = hn::Vec<D64>;

// Modulo 2^64.
[[nodiscard]] HWY_INLINE V64 product(V64 a, V64 b) {
  const hn::Repartition<uint32_t, D64> d32;
  const auto a_low = hn::BitCast(d32, a), b_low = hn::BitCast(d32, b);
  const auto a_high = hn::BitCast(d32, hn::ShiftRight<32>(a));
  const auto b_high = hn::BitCast(d32, hn::ShiftRight<32>(b));
  const V64 cross = hn::Add(hn::MulEven(a_high, b_low), hn::MulEven(a_low, b_high));
  return hn::Add(hn::MulEven(a_low, b_low), hn::ShiftLeft<32>(cross));
}

// ExactRow::u_texel for kLanes pixels at once, all modulo 2^64: lanes of 32.32 say the low texel,
// and it is the next one where n - (low + 1) d is not negative.
[[nodiscard]] HWY_INLINE V32 exact_texels(int64_t lane_fx32, int64_t step_fx32, uint64_t n,
                                          uint64_t n_step, uint64_t d) {
  const D64 d64;
  const D32 d32;
  const auto half = [&](uint64_t first, V32* low) {
    const V64 i = hn::Iota(d64, first);
    const V64 lane = hn::Add(hn::Set(d64, static_cast<uint64_t>(lane_fx32)),
                             product(i, hn::Set(d64, static_cast<uint64_t>(step_fx32))));
    *low = hn::BitCast(d32, lane);
    const hn::RebindToSigned<D64> di64;
    const auto texel = hn::ShiftRight<kLaneFraction>(hn::BitCast(di64, lane));
    const V64 next = hn::BitCast(d64, hn::Add(texel, hn::Set(di64, 1)));
    const V64 at = hn::Add(hn::Set(d64, n), product(i, hn::Set(d64, n_step)));
    return hn::BitCast(d32, hn::Sub(at, product(next, hn::Set(d64, d))));
  };
  V32 lanes_low, lanes_high;
  const V32 rest_low = half(0, &lanes_low), rest_high = half(kLanes / 2, &lanes_high);
  const V32 texel = hn::ConcatOdd(d32, lanes_high, lanes_low);
  const V32 rest_sign = hn::ShiftRight<31>(hn::ConcatOdd(d32, rest_high, rest_low));
  return hn::Add(hn::Add(texel, rest_sign), hn::Set(d32, 1));
}

template <class Address>
class AffineBatch {
 public:
  HWY_INLINE AffineBatch(const AffineSpans& spans, const Surface& surface)
      : spans_(spans),
        width_texel_(surface.texture.width),
        height_texel_(surface.texture.height),
        pitch_texel_(pitch_texel(surface.texture)),
        lack_fx16_(kVectorTruncations_fx16 +
                   static_cast<int32_t>(spans.field.margin_fx32 >> kAnchorShift) + 1),
        offset_u_(offsets_fx16(spans.field.step_x.u_fx32)),
        offset_v_(offsets_fx16(spans.field.step_x.v_fx32)) {}

  // Writes the places in the texture, in texels from its first, of kLanes pixels from `px` on, of
  // which `count` are asked for; the others' are valid places too. Returns how many it decided.
  HWY_INLINE int32_t find_places(int32_t row, int32_t px, Lane lane, int32_t count,
                                 int32_t* HWY_RESTRICT place) const {
    const D32 d;
    const V32 u = hn::Add(hn::Set(d, floor_fx16(lane.u_fx32)), offset_u_);
    const V32 v = hn::Add(hn::Set(d, floor_fx16(lane.v_fx32)), offset_v_);
    store_places(hn::ShiftRight<kTexelFraction>(u), hn::ShiftRight<kTexelFraction>(v), place);

    // Where adding what a lane may lack changes the texel.
    const V32 lack = hn::Set(d, lack_fx16_);
    const V32 change = hn::Or(hn::Xor(hn::Add(u, lack), u), hn::Xor(hn::Add(v, lack), v));
    const auto near = hn::And(hn::Ne(hn::ShiftRight<kTexelFraction>(change), hn::Zero(d)),
                              hn::FirstN(d, static_cast<size_t>(count)));
    if (HWY_LIKELY(hn::AllFalse(d, near))) return 0;
    return decide_places(row, px, lane, lane_bits(d, near), place);
  }

 private:
  // The near-ties among the pixels, by the exact map; low texels are those of the 32.32 lanes.
  HWY_NOINLINE int32_t decide_places(int32_t row, int32_t px, Lane lane, uint32_t near,
                                     int32_t* place) const {
    const ExactRow exact = spans_.exact.row_from(px, row);
    const Lane& step = spans_.field.step_x;
    if (exact.fits_int64()) {
      const auto low64 = [](uint128 a) { return static_cast<uint64_t>(a); };
      const auto d = low64(exact.d);
      const V32 s = exact_texels(lane.u_fx32, step.u_fx32, low64(exact.u), low64(exact.u_step), d);
      const V32 t = exact_texels(lane.v_fx32, step.v_fx32, low64(exact.v), low64(exact.v_step), d);
      store_places(s, t, place);
      return static_cast<int32_t>(hwy::PopCount(near));
    }
    int32_t decided = 0;
    for (int32_t i = 0; near >> i != 0; ++i) {
      if ((near >> i & 1U) == 0) continue;
      const int32_t s = exact.u_texel(i, floor_texel(lane.u_fx32 + i * step.u_fx32));
      const int32_t t = exact.v_texel(i, floor_texel(lane.v_fx32 + i * step.v_fx32));
      place[i] = Address::Scalar::index(t, height_texel_) * pitch_texel_ +
                 Address::Scalar::index(s, width_texel_);
      ++decided;
    }
    return decided;
  }

  HWY_INLINE void store_places(V32 s, V32 t, int32_t* HWY_RESTRICT place) const {
    const D32 d;
    const V32 row = hn::Mul(Address::index(t, height_texel_), hn::Set(d, pitch_texel_));
    hn::StoreU(hn::Add(row, Address::index(s, width_texel_)), d, place);
  }

  const AffineSpans& spans_;
  int32_t width_texel_, height_texel_, pitch_texel_;
  int32_t lack_fx16_;
  V32 offset_u_, offset_v_;
};

template <class Pixel, class Address>
int32_t draw_wide(const AffineSpans& spans, const Surface& surface) {
  const AffineBatch<Address> batch(spans, surface);
  const Lane step = spans.field.step_x;
  HWY_ALIGN int32_t place[kLanes];
  int32_t decided = 0;
  for (int32_t i = 0; i < spans.batch.rows; ++i) {
    const Span span = spans.batch.span(i);
    Lane lane = spans.field.at(span.left_px, span.row);
    char* pixel = first_pixel<Pixel>(surface, span);
    int32_t px = span.left_px;
    for (; span.right_px - px >= kLanes; px += kLanes) {
      decided += batch.find_places(span.row, px, lane, kLanes, place);
      fetch<Pixel>(surface.texture.texels, place, kLanes, pixel);
      pixel += kLanes * ptrdiff_t{sizeof(Pixel)};
      lane.u_fx32 += kLanes * step.u_fx32;
      lane.v_fx32 += kLanes * step.v_fx32;
    }
    decided += batch.find_places(span.row, px, lane, span.right_px - px, place);
    fetch<Pixel>(surface.texture.texels, place, span.right_px - px, pixel);
  }
  return decided;
}

// Spans up to kNarrow_px wide: the places of all one after another, their texels in one loop, then
// each row stored under a mask. Hardly a branch depends on a span's width.
template <class Pixel, class Address>
int32_t draw_narrow(const AffineSpans& spans, const Surface& surface) {
  const AffineBatch<Address> batch(spans, surface);
  const AffineField field = spans.field;
  HWY_ALIGN int32_t place[kRowsPerBatch * kNarrow_px + kMostLanes];
  HWY_ALIGN Pixel texel[kRowsPerBatch * kNarrow_px + kNarrow_px];
  int32_t decided = 0, count = 0;
  for (int32_t i = 0; i < spans.batch.rows; ++i) {
    const Span span = spans.batch.span(i);
    int32_t px = span.left_px;
    do {
      decided += batch.find_places(span.row, px, field.at(px, span.row),
                                   std::min(span.right_px - px, kLanes),
                                   place + count + (px - span.left_px));
      px += kLanes;
    } while (px < span.right_px);
    count += span.width_px();
  }
  fetch<Pixel>(surface.texture.texels, place, count, reinterpret_cast<char*>(texel));
  const Pixel* row = texel;
  for (int32_t i = 0; i < spans.batch.rows; ++i) {
    const Span span = spans.batch.span(i);
    store_row<Pixel>(row, span.width_px(), first_pixel<Pixel>(surface, span));
    row += span.width_px();
  }
  return decided;
}

int32_t draw_affine(const AffineSpans& spans, const Surface& surface) {
  const bool narrow = spans.batch.widest_px <= kNarrow_px;
  return with_pixel(surface.target.format, [&](auto pixel) {
    return with_address(surface, [&](auto address) {
      using Pixel = decltype(pixel);
      using Address = decltype(address);
      return narrow ? draw_narrow<Pixel, Address>(spans, surface)
                    : draw_wide<Pixel, Address>(spans, surface);
    });
  });
}

}  // namespace
}  // namespace selvage::mapper::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
