// What others leave of affine spans: vectors with near-ties, and those that do not lie in their
// window. Included once for each SIMD target.
#if defined(SELVAGE_VECTOR_AFFINE_REST_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SELVAGE_VECTOR_AFFINE_REST_INL_H
#undef SELVAGE_VECTOR_AFFINE_REST_INL_H
#else
#define SELVAGE_VECTOR_AFFINE_REST_INL_H
#endif

#include "mapper/vector_affine_exact-inl.h"
#include "mapper/vector_affine_ties-inl.h"
#include "mapper/vector_batch_ties-inl.h"
#include "mapper/vector_left-inl.h"

HWY_BEFORE_NAMESPACE();
namespace selvage::mapper::HWY_NAMESPACE {
namespace {

template <class Ties>
HWY_NOINLINE void decide_left(const Left& left, const AffineSpans& spans, const Surface& surface,
                              int32_t window_rows, Ties* ties, LeftTexels* texels) {
  const AffineBatch<Addressed<InsideVector>> batch(spans, surface);  // for its lanes alone
  for (int32_t i = 0; i < left.count; ++i) {
    const Span& rest = left.at(i);
    if (rest.row != ties->span().row) ties->go_to(rest);
    const Lane anchor = batch.anchor(spans.field.at(rest.left_px, rest.row));
    const int32_t offset_px = rest.left_px - ties->span().left_px;
    texels->put(i, batch.decided(*ties, offset_px, batch.lanes_from(anchor)), window_rows);
  }
}

template <class Pixel, class Address>
HWY_NOINLINE void draw_left(const Left& left, const AffineSpans& spans, const Surface& surface,
                            int32_t window_rows, AffineBatchTies* batch_ties) {
  LeftTexels texels;
  batch_ties->with_ties(
      [&](auto* ties) { decide_left(left, spans, surface, window_rows, ties, &texels); });
  draw_left<Pixel, Address>(left, texels, surface);
}

// Of a small polygon, which has finer lanes than vectors, a pixel at a time costs less, too.
[[nodiscard]] HWY_INLINE bool is_small(const AffineField& field) {
  constexpr uint32_t kSmall_fx32 = 128;
  return field.margin_fx32 <= kSmall_fx32;
}

// Draws what is left of a batch. Who leaves it need not know how, nor by which address mode, so
// that there is one of each for all of them.
class RestDraw {
 public:
  // The vectors that are left of so many. Where they are many, all rows from an index in the batch
  // on are drawn, and false is returned.
  HWY_INLINE bool draw(const Left& left, int32_t first_index, int32_t of_vectors) {
    return draw_as_(this, left, first_index, of_vectors);
  }

 protected:
  using DrawAs = bool (*)(RestDraw* rest, const Left& left, int32_t first_index,
                          int32_t of_vectors);

  explicit HWY_INLINE RestDraw(DrawAs by) : draw_as_(by) {}

 private:
  DrawAs draw_as_;
};

// Of spans under one map.
class AffineRest : public RestDraw {
 public:
  template <class Pixel, class Address>
  static HWY_INLINE AffineRest of(const AffineSpans& spans, const Surface& surface,
                                  int32_t window_rows) {
    return {spans, surface, window_rows, draw_as<Pixel, Address>};
  }
  // Whether near-ties were many of some vectors.
  [[nodiscard]] HWY_INLINE bool had_many() const { return had_many_; }

 private:
  HWY_INLINE AffineRest(const AffineSpans& spans, const Surface& surface, int32_t window_rows,
                        DrawAs by)
      : RestDraw(by),
        spans_(spans),
        surface_(surface),
        window_rows_(window_rows),
        batch_ties_(spans.exact, spans.batch, spare_bits_fx16(lack_fx16(spans.field.margin_fx32))) {
  }

  template <class Pixel, class Address>
  static HWY_NOINLINE bool draw_as(RestDraw* of, const Left& left, int32_t first_index,
                                   int32_t of_vectors) {
    auto* const rest = static_cast<AffineRest*>(of);
    const AffineSpans& spans = rest->spans_;
    const Surface& surface = rest->surface_;
    if (are_many(left.count, of_vectors)) {
      rest->had_many_ = true;
      if (draw_near_ties<Pixel, Address>(spans, surface, first_index)) return false;
      if (has_quotients(spans)) {
        draw_exactly<Pixel, Address>(spans, surface, first_index, rest->window_rows_);
        return false;
      }
      if (is_small(spans.field)) {
        scalar_kernels(SELVAGE_FILTER_NEAREST).draw_affine(spans, surface);
        return false;
      }
    }
    draw_left<Pixel, Address>(left, spans, surface, rest->window_rows_, &rest->batch_ties_);
    return true;
  }

  const AffineSpans& spans_;
  const Surface& surface_;
  int32_t window_rows_;
  bool had_many_ = false;
  AffineBatchTies batch_ties_;
};

}  // namespace
}  // namespace selvage::mapper::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
