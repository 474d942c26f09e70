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

template <class Address>
class AffineBatch {
 public:
  HWY_INLINE AffineBatch(const AffineSpans& spans, const Surface& surface)
      : width_texel_(surface.texture.width),
        height_texel_(surface.texture.height),
        pitch_texel_(pitch_texel(surface.texture)),
        lack_fx16_(kVectorTruncations_fx16 +
                   static_cast<int32_t>(spans.field.margin_fx32 >> kAnchorShift) + 1),
        offset_u_(offsets_fx16(spans.field.step_x.u_fx32)),
        offset_v_(offsets_fx16(spans.field.step_x.v_fx32)) {}

  // Writes the places in the texture, in texels from its first, of kLanes pixels from an offset in
  // a span on, of which `count` are asked for; the others' are valid places too. Returns how many
  // it decided.
  HWY_INLINE int32_t find_places(RowOnDemand& exact, int32_t offset_px, Lane lane, int32_t count,
                                 int32_t* HWY_RESTRICT place) const {
    const D32 d;
    const V32 u = hn::Add(hn::Set(d, floor_fx16(lane.u_fx32)), offset_u_);
    const V32 v = hn::Add(hn::Set(d, floor_fx16(lane.v_fx32)), offset_v_);
    store_places(texel_of(u), texel_of(v), place);
    const auto asked = hn::FirstN(d, static_cast<size_t>(count));
    const auto near = hn::And(is_changed(hn::Or(change(u), change(v))), asked);
    if (HWY_LIKELY(hn::AllFalse(d, near))) return 0;
    decide_places(exact, offset_px, u, v, lane_bits(d, near), place);
    return static_cast<int32_t>(hn::CountTrue(d, near));
  }

 private:
  static HWY_INLINE V32 texel_of(V32 lane_fx16) {
    return hn::ShiftRight<kTexelFraction>(lane_fx16);
  }
  // Beyond the fraction, what adding all that a lane may lack changes in it.
  HWY_INLINE V32 change(V32 lane_fx16) const {
    return hn::Xor(hn::Add(lane_fx16, hn::Set(D32(), lack_fx16_)), lane_fx16);
  }
  static HWY_INLINE hn::Mask<D32> is_changed(V32 change) {
    return hn::Ne(texel_of(change), hn::Zero(D32()));
  }

  HWY_NOINLINE void decide_places(RowOnDemand& exact, int32_t offset_px, V32 u, V32 v,
                                  uint32_t asked, int32_t* place) const {
    const D32 d;
    const ExactRow& row = exact.get();
    const uint32_t near_u = lane_bits(d, is_changed(change(u))) & asked;
    const uint32_t near_v = lane_bits(d, is_changed(change(v))) & asked;
    store_places(decide(d, texel_of(u), near_u, row, row.u, offset_px),
                 decide(d, texel_of(v), near_v, row, row.v, offset_px), place);
  }

  HWY_INLINE void store_places(V32 s, V32 t, int32_t* HWY_RESTRICT place) const {
    const D32 d;
    const V32 row = hn::Mul(Address::index(t, height_texel_), hn::Set(d, pitch_texel_));
    hn::StoreU(hn::Add(row, Address::index(s, width_texel_)), d, place);
  }

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
    RowOnDemand exact(spans.exact, span);
    Lane lane = spans.field.at(span.left_px, span.row);
    char* pixel = first_pixel<Pixel>(surface, span);
    int32_t px = span.left_px;
    for (; span.right_px - px >= kLanes; px += kLanes) {
      decided += batch.find_places(exact, px - span.left_px, lane, kLanes, place);
      fetch<Pixel>(surface.texture.texels, place, kLanes, pixel);
      pixel += kLanes * ptrdiff_t{sizeof(Pixel)};
      lane.u_fx32 += kLanes * step.u_fx32;
      lane.v_fx32 += kLanes * step.v_fx32;
    }
    decided += batch.find_places(exact, px - span.left_px, lane, span.right_px - px, place);
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
    RowOnDemand exact(spans.exact, span);
    int32_t offset_px = 0;
    do {
      decided += batch.find_places(exact, offset_px, field.at(span.left_px + offset_px, span.row),
                                   std::min(span.width_px() - offset_px, kLanes),
                                   place + count + offset_px);
      offset_px += kLanes;
    } while (offset_px < span.width_px());
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
