// Affine spans that are shorter than some vectors, packed. Included once for each SIMD target.
#if defined(SELVAGE_VECTOR_AFFINE_NARROW_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SELVAGE_VECTOR_AFFINE_NARROW_INL_H
#undef SELVAGE_VECTOR_AFFINE_NARROW_INL_H
#else
#define SELVAGE_VECTOR_AFFINE_NARROW_INL_H
#endif

#include "mapper/vector_affine_lanes-inl.h"
#include "mapper/vector_batch_ties-inl.h"

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

// The lanes of a batch's pixels, packed one row after another.
struct PackedLanes {
  static constexpr int32_t kMost = kRowsPerBatch * kNarrow_px;
  int32_t count;
  HWY_ALIGN int32_t u_fx16[kMost + kMostLanes], v_fx16[kMost + kMostLanes];

  // Of lanes_of(px, row), a vector of pixels of a row.
  template <class LanesOf>
  HWY_INLINE void pack(const SpanBatch& batch, const LanesOf& lanes_of) {
    const D32 d;
    count = 0;
    for (int32_t i = 0; i < batch.rows; ++i) {
      const Span span = batch.span(i);
      int32_t done = 0;
      do {
        const LaneVectors lanes = lanes_of(span.left_px + done, span.row);
        hn::StoreU(lanes.u, d, u_fx16 + count + done);
        hn::StoreU(lanes.v, d, v_fx16 + count + done);
        done += kLanes;
      } while (done < span.width_px());
      count += span.width_px();
    }
    hn::StoreU(hn::Zero(d), d, u_fx16 + count);
    hn::StoreU(hn::Zero(d), d, v_fx16 + count);
  }
  [[nodiscard]] HWY_INLINE LaneVectors from(int32_t first) const {
    return {hn::Load(D32(), u_fx16 + first), hn::Load(D32(), v_fx16 + first)};
  }
};

// Packs lanes of which no fraction is left, so that none is a near-tie.
template <class Address, class LanesOf>
HWY_NOINLINE void pack_decided(const SpanBatch& batch, const ExactMap& exact,
                               const FixedLanes<Address>& fixed, const LanesOf& lanes_of,
                               PackedLanes* packed) {
  BatchTies batch_ties(exact, batch, fixed.spare_bits());
  batch_ties.with_ties([&](auto* ties) HWY_ATTR {
    packed->pack(batch, [&](int32_t px, int32_t row) HWY_ATTR {
      const Span span = batch.span(row - batch.first_row);
      if (span.empty()) return lanes_of(px, row);  // exact maps are of pixels
      if (row != ties->span().row) ties->go_to(span);
      const TexelVectors texels = fixed.decided(*ties, px - span.left_px, lanes_of(px, row));
      return LaneVectors{hn::ShiftLeft<kTexelFraction>(texels.s),
                         hn::ShiftLeft<kTexelFraction>(texels.t)};
    });
  });
}

// Spans up to kNarrow_px wide: the lanes of all are packed, so that vectors are full although rows
// are short; each row is stored under a mask. lanes_of(px, row) are those of a vector of pixels.
template <class Address, class LanesOf>
HWY_INLINE void draw_packed(const SpanBatch& batch, const ExactMap& exact,
                            const FixedLanes<Address>& fixed, const Surface& surface,
                            const LanesOf& lanes_of) {
  PackedLanes packed;
  packed.pack(batch, lanes_of);
  HWY_ALIGN int32_t place[kLanes];
  HWY_ALIGN char texels[(PackedLanes::kMost + kMostLanes) * sizeof(uint32_t)];
  const ptrdiff_t bytes = bytes_per_pixel(surface.target.format);
  for (int32_t first = 0; first < packed.count; first += kLanes) {
    if (HWY_UNLIKELY(fixed.any_near(packed.from(first)))) {
      pack_decided(batch, exact, fixed, lanes_of, &packed);
    }
    hn::Store(fixed.places(packed.from(first)), D32(), place);
    fetch(surface.texture, place, kLanes, texels + first * bytes);
  }
  with_pixel(surface.target.format, [&](auto pixel) {
    store_rows(reinterpret_cast<const decltype(pixel)*>(texels), batch, surface);
  });
}

template <class Address>
void draw_narrow(const AffineSpans& spans, const Surface& surface) {
  const AffineBatch<Address> batch(spans, surface);
  draw_packed<Address>(spans.batch, spans.exact, batch, surface,
                       [&](int32_t px, int32_t row) HWY_ATTR {
                         return batch.lanes_from(batch.anchor(spans.field.at(px, row)));
                       });
}

}  // namespace
}  // namespace selvage::mapper::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
