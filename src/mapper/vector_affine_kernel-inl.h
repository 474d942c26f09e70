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

// kLanes lanes of both coordinates.
struct LaneVectors {
  V32 u, v;
};

// Near-ties among the pixels of many short rows, packed one row after another.
class PackedTies {
 public:
  HWY_INLINE explicit PackedTies(const AffineSpans& spans)
      : rows_(spans.batch), ties_(spans.exact, rows_.span(0), 0) {}

  // As RowOfTies does, for packed pixels from a number on that never falls.
  HWY_INLINE void decide(int32_t first, bool any_u, bool any_v, V32* HWY_RESTRICT s,
                         V32* HWY_RESTRICT t) {
    const D32 d;
    const V32 low_s = *s, low_t = *t, lane = hn::Iota(d, 0);
    while (end() <= first && next_row()) continue;
    do {
      V32 row_s = low_s, row_t = low_t;
      ties_.decide(d, first - first_of_row_, any_u, any_v, &row_s, &row_t);
      const auto is_left = hn::Lt(lane, hn::Set(d, first_of_row_ - first));
      *s = hn::IfThenElse(is_left, *s, row_s);
      *t = hn::IfThenElse(is_left, *t, row_t);
    } while (end() < first + kLanes && next_row());
  }

 private:
  HWY_INLINE int32_t end() const { return first_of_row_ + rows_.span(row_).width_px(); }
  HWY_INLINE bool next_row() {
    if (row_ + 1 == rows_.rows) return false;
    first_of_row_ = end();
    ties_.go_to(rows_.span(++row_));
    return true;
  }

  const SpanBatch& rows_;
  RowOfTies ties_;
  int32_t row_ = 0, first_of_row_ = 0;
};

template <class Address>
class AffineBatch {
 public:
  HWY_INLINE AffineBatch(const AffineSpans& spans, const Surface& surface)
      : extent_(extent_of(surface.texture)),
        lack_fx16_(kVectorTruncations_fx16 +
                   static_cast<int32_t>(spans.field.margin_fx32 >> kAnchorShift) + 1),
        offset_u_(offsets_fx16(spans.field.step_x.u_fx32)),
        offset_v_(offsets_fx16(spans.field.step_x.v_fx32)) {}

  // Of kLanes pixels, given the 32.32 lane of the first.
  HWY_INLINE LaneVectors lanes_from(Lane lane) const {
    const D32 d;
    return {hn::Add(hn::Set(d, floor_fx16(lane.u_fx32)), offset_u_),
            hn::Add(hn::Set(d, floor_fx16(lane.v_fx32)), offset_v_)};
  }

  // Places in the texture, in texels from its first; those of lanes that mean nothing are valid
  // too.
  HWY_INLINE V32 places(const LaneVectors& lanes) const {
    return places_of(texel_of(lanes.u), texel_of(lanes.v));
  }

  // Whether adding all that a lane may lack changes some texel.
  [[nodiscard]] HWY_INLINE bool any_near(const LaneVectors& lanes) const {
    return !hn::AllFalse(D32(), is_changed(hn::Or(change(lanes.u), change(lanes.v))));
  }
  [[nodiscard]] HWY_INLINE bool has_near(V32 lane_fx16) const {
    return !hn::AllFalse(D32(), is_changed(change(lane_fx16)));
  }

  // The places of pixels that follow each other in a row, near-ties and all.
  HWY_NOINLINE V32 decided_places(RowOfTies& row, int32_t offset_px,
                                  const LaneVectors& lanes) const {
    V32 s = texel_of(lanes.u), t = texel_of(lanes.v);
    row.decide(D32(), offset_px, has_near(lanes.u), has_near(lanes.v), &s, &t);
    return places_of(s, t);
  }

  // Those of packed pixels from a number on.
  HWY_NOINLINE V32 decided_places(PackedTies& packed, int32_t first,
                                  const LaneVectors& lanes) const {
    V32 s = texel_of(lanes.u), t = texel_of(lanes.v);
    packed.decide(first, has_near(lanes.u), has_near(lanes.v), &s, &t);
    return places_of(s, t);
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

  Extent extent_;
  int32_t lack_fx16_;
  V32 offset_u_, offset_v_;
};

template <class Pixel, class Address>
void draw_wide(const AffineSpans& spans, const Surface& surface) {
  const AffineBatch<Address> batch(spans, surface);
  const D32 d;
  const int64_t step_u = kLanes * spans.field.step_x.u_fx32;
  const int64_t step_v = kLanes * spans.field.step_x.v_fx32;
  HWY_ALIGN int32_t place[kLanes];
  for (int32_t i = 0; i < spans.batch.rows; ++i) {
    const Span span = spans.batch.span(i);
    Lane lane = spans.field.at(span.left_px, span.row);
    char* pixel = first_pixel(surface, span);
    RowOfTies ties(spans.exact, span, 0);
    for (int32_t px = span.left_px; px < span.right_px; px += kLanes) {
      const int32_t count = HWY_MIN(span.right_px - px, kLanes);
      const LaneVectors lanes = batch.lanes_from(lane);
      hn::Store(batch.places(lanes), d, place);
      if (HWY_UNLIKELY(batch.any_near(lanes))) {
        hn::Store(batch.decided_places(ties, px - span.left_px, lanes), d, place);
      }
      if (HWY_LIKELY(count == kLanes)) {
        fetch_as<Pixel>(surface.texture.texels, place, kLanes, pixel);
      } else {
        fetch_as<Pixel>(surface.texture.texels, place, count, pixel);
      }
      pixel += kLanes * ptrdiff_t{sizeof(Pixel)};
      lane.u_fx32 += step_u;
      lane.v_fx32 += step_v;
    }
  }
}

template <class Pixel>
HWY_INLINE void store_rows(const Pixel* texels, const SpanBatch& batch, const Surface& surface) {
  for (int32_t i = 0; i < batch.rows; ++i) {
    const Span span = batch.span(i);
    store_row<Pixel>(texels, span.width_px(), first_pixel(surface, span));
    texels += span.width_px();
  }
}

// Spans up to kNarrow_px wide: the lanes of all are packed one after another, so that vectors are
// full although rows are short; each row is stored under a mask.
template <class Address>
void draw_narrow(const AffineSpans& spans, const Surface& surface) {
  constexpr int32_t kMost = kRowsPerBatch * kNarrow_px;
  const AffineBatch<Address> batch(spans, surface);
  const AffineField field = spans.field;
  const D32 d;
  HWY_ALIGN int32_t u_fx16[kMost + kMostLanes], v_fx16[kMost + kMostLanes];
  int32_t packed = 0;
  for (int32_t i = 0; i < spans.batch.rows; ++i) {
    const Span span = spans.batch.span(i);
    int32_t done = 0;
    do {
      const LaneVectors lanes = batch.lanes_from(field.at(span.left_px + done, span.row));
      hn::StoreU(lanes.u, d, u_fx16 + packed + done);
      hn::StoreU(lanes.v, d, v_fx16 + packed + done);
      done += kLanes;
    } while (done < span.width_px());
    packed += span.width_px();
  }
  hn::StoreU(hn::Zero(d), d, u_fx16 + packed);
  hn::StoreU(hn::Zero(d), d, v_fx16 + packed);

  PackedTies ties(spans);
  HWY_ALIGN int32_t place[kLanes];
  HWY_ALIGN char texels[(kMost + kMostLanes) * sizeof(uint32_t)];
  const ptrdiff_t bytes = bytes_per_pixel(surface.target.format);
  for (int32_t first = 0; first < packed; first += kLanes) {
    const LaneVectors lanes{hn::Load(d, u_fx16 + first), hn::Load(d, v_fx16 + first)};
    hn::Store(batch.places(lanes), d, place);
    if (HWY_UNLIKELY(batch.any_near(lanes))) {
      hn::Store(batch.decided_places(ties, first, lanes), d, place);
    }
    fetch(surface.texture, place, kLanes, texels + first * bytes);
  }
  with_pixel(surface.target.format, [&](auto pixel) {
    store_rows(reinterpret_cast<const decltype(pixel)*>(texels), spans.batch, surface);
  });
}

// The pixel's type is known to the loop that most time is spent in.
void draw_affine(const AffineSpans& spans, const Surface& surface) {
  const bool narrow = spans.batch.widest_px <= kNarrow_px;
  with_address(surface, [&](auto address) {
    using Address = decltype(address);
    if (narrow) return draw_narrow<Address>(spans, surface);
    with_pixel(surface.target.format,
               [&](auto pixel) { draw_wide<decltype(pixel), Address>(spans, surface); });
  });
}

}  // namespace
}  // namespace selvage::mapper::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
