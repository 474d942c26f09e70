// Affine spans that are shorter than some vectors, packed. Included once for each SIMD target.
#if defined(SELVAGE_VECTOR_AFFINE_NARROW_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SELVAGE_VECTOR_AFFINE_NARROW_INL_H
#undef SELVAGE_VECTOR_AFFINE_NARROW_INL_H
#else
#define SELVAGE_VECTOR_AFFINE_NARROW_INL_H
#endif

#include "mapper/vector_affine_exact-inl.h"
#include "mapper/vector_affine_lanes-inl.h"
#include "mapper/vector_packed_ties-inl.h"

HWY_BEFORE_NAMESPACE();
namespace selvage::mapper::HWY_NAMESPACE {
namespace {

template <class Pixel>
HWY_INLINE void store_rows(const Pixel* texels, const SpanBatch& batch, const Surface& surface) {
  for (int32_t i = 0; i < batch.rows; ++i) {
    const Span span = batch.span(i);
    store_row<Pixel>(texels, span.width_px(), first_pixel(surface, span));
    texels += span.width_px();
  }
}

// Spans up to kNarrow_px wide: the lanes of all are packed one after another, so that vectors are
// full although rows are short; each row is stored under a mask. False where they are better drawn
// by exact quotients.
template <class Address>
[[nodiscard]] bool draw_narrow(const AffineSpans& spans, const Surface& surface) {
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
      const LaneVectors lanes =
          batch.lanes_from(batch.anchor(field.at(span.left_px + done, span.row)));
      hn::StoreU(lanes.u, d, u_fx16 + packed + done);
      hn::StoreU(lanes.v, d, v_fx16 + packed + done);
      done += kLanes;
    } while (done < span.width_px());
    packed += span.width_px();
  }
  hn::StoreU(hn::Zero(d), d, u_fx16 + packed);
  hn::StoreU(hn::Zero(d), d, v_fx16 + packed);

  PackedTies ties(spans.batch, spans.exact, 0, batch.spare_bits());
  HWY_ALIGN int32_t place[kLanes];
  HWY_ALIGN char texels[(kMost + kMostLanes) * sizeof(uint32_t)];
  const ptrdiff_t bytes = bytes_per_pixel(surface.target.format);
  int32_t near = 0;
  for (int32_t first = 0; first < packed; first += kLanes) {
    const LaneVectors lanes{hn::Load(d, u_fx16 + first), hn::Load(d, v_fx16 + first)};
    hn::Store(batch.places(lanes), d, place);
    if (HWY_UNLIKELY(batch.any_near(lanes))) {
      if (are_many(++near, first / kLanes + 1) && has_quotients(spans)) return false;
      hn::Store(batch.decided_places(ties, first, lanes), d, place);
    }
    fetch(surface.texture, place, kLanes, texels + first * bytes);
  }
  with_pixel(surface.target.format, [&](auto pixel) {
    store_rows(reinterpret_cast<const decltype(pixel)*>(texels), spans.batch, surface);
  });
  return true;
}

}  // namespace
}  // namespace selvage::mapper::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
