// Affine spans that are shorter than some vectors, packed. Included once for each SIMD target.
#if defined(SELVAGE_VECTOR_AFFINE_NARROW_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SELVAGE_VECTOR_AFFINE_NARROW_INL_H
#undef SELVAGE_VECTOR_AFFINE_NARROW_INL_H
#else
#define SELVAGE_VECTOR_AFFINE_NARROW_INL_H
#endif

#include "mapper/vector_affine_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace selvage::mapper::HWY_NAMESPACE {
namespace {

// Near-ties among packed pixels [first, first + kLanes): finds each one's row by the widths.
template <class Address>
HWY_NOINLINE void decide_packed(const AffineBatch<Address>& batch, const SpanBatch& rows,
                                const LaneVectors& lanes, int32_t first, int32_t* place) {
  HWY_ALIGN int32_t u_fx16[kLanes], v_fx16[kLanes];
  hn::Store(lanes.u, D32(), u_fx16);
  hn::Store(lanes.v, D32(), v_fx16);
  const uint32_t near = batch.near_bits(lanes.u) | batch.near_bits(lanes.v);
  int32_t row = 0, row_first = 0;
  for (int32_t i = 0; near >> i != 0; ++i) {
    if ((near >> i & 1U) == 0) continue;
    while (row < rows.rows && first + i >= row_first + rows.span(row).width_px()) {
      row_first += rows.span(row++).width_px();
    }
    if (row == rows.rows) break;  // beyond the last pixel
    const Span span = rows.span(row);
    place[i] =
        batch.decided_place(span.left_px + first + i - row_first, span.row, u_fx16[i], v_fx16[i]);
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

  HWY_ALIGN int32_t place[kLanes];
  HWY_ALIGN char texels[(kMost + kMostLanes) * sizeof(uint32_t)];
  const ptrdiff_t bytes = bytes_per_pixel(surface.target.format);
  for (int32_t first = 0; first < packed; first += kLanes) {
    const LaneVectors lanes{hn::Load(d, u_fx16 + first), hn::Load(d, v_fx16 + first)};
    hn::Store(batch.places(lanes), d, place);
    if (HWY_UNLIKELY(batch.any_near(lanes))) {
      decide_packed(batch, spans.batch, lanes, first, place);
    }
    fetch(surface.texture, place, kLanes, texels + first * bytes);
  }
  with_pixel(surface.target.format, [&](auto pixel) {
    store_rows(reinterpret_cast<const decltype(pixel)*>(texels), spans.batch, surface);
  });
}

}  // namespace
}  // namespace selvage::mapper::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
