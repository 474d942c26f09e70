// What others leave of affine spans: vectors with near-ties, and those that do not lie in their
// window. Included once for each SIMD target.
#if defined(SELVAGE_VECTOR_AFFINE_REST_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SELVAGE_VECTOR_AFFINE_REST_INL_H
#undef SELVAGE_VECTOR_AFFINE_REST_INL_H
#else
#define SELVAGE_VECTOR_AFFINE_REST_INL_H
#endif

#include "mapper/boundary.h"
#include "mapper/vector/affine_exact-inl.h"
#include "mapper/vector/affine_ties-inl.h"
#include "mapper/vector/batch_ties-inl.h"
#include "mapper/vector/left-inl.h"
#include "mapper/vector/whole_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace selvage::mapper::HWY_NAMESPACE {
namespace {

template <class Ties>
HWY_NOINLINE void decide_left(const Left& left, const AffineSpans& spans, int32_t window_rows,
                              Ties* ties, LeftTexels* texels) {
  const WholeLanes lanes(spans.field.step_x, spans.field.margin_fx32);
  for (int32_t i = 0; i < left.count; ++i) {
    const Span& rest = left.at(i);
    WholeTexels whole = lanes.from(spans.field.at(rest.left_px, rest.row));
    if (rest.row != ties->span().row) ties->go_to(rest);
    ties->decide(rest.left_px - ties->span().left_px, whole.near, &whole.s, &whole.t);
    texels->put(i, whole, window_rows);
  }
}

template <class Pixel, class Address>
HWY_NOINLINE void draw_left(const Left& left, const AffineSpans& spans, const Surface& surface,
                            int32_t window_rows, AffineBatchTies* batch_ties) {
  LeftTexels texels;
  batch_ties->with_ties([&](auto* ties) { decide_left(left, spans, window_rows, ties, &texels); });
  draw_left<Pixel, Address>(left, texels, surface);
}

// Of a small polygon, which has finer lanes than vectors, a pixel at a time costs less, too.
[[nodiscard]] HWY_INLINE bool is_small(const AffineField& field) {
  constexpr uint32_t kSmall_fx32 = 128;
  return field.margin_fx32 <= kSmall_fx32;
}

// Draws rows with many near-ties, from an index in the batch on, by what is in no doubt anywhere:
// false where it costs less to decide vectors one by one.
template <class Pixel, class Address>
[[nodiscard]] HWY_INLINE bool draw_without_doubt(const AffineSpans& spans, const Surface& surface,
                                                 int32_t first_index, int32_t window_rows) {
  if (draw_near_ties<Pixel, Address>(spans, surface, first_index)) return true;
  if (has_quotients(spans)) {
    draw_exactly<Pixel, Address>(spans, surface, first_index, window_rows);
    return true;
  }
  if (!is_small(spans.field)) return false;
  scalar_kernels(SELVAGE_FILTER_NEAREST).draw_affine(spans, surface);
  return true;
}

[[nodiscard]] HWY_INLINE AffineBatchTies ties_of(const AffineSpans& spans) {
  return {spans.exact, spans.batch, spare_bits_fx16(lack_fx16(spans.field.margin_fx32))};
}

// A row, and where one of its coordinates shows two texels alone: how many pixels at its left show
// one of them; in that coordinate no pixel is in doubt.
struct RowOfTwo {
  int32_t left_px;  // -1 where there is no such coordinate, or it is not certain
  int64_t Lane::*axis;
  int32_t texel[2];

  static HWY_INLINE RowOfTwo of(const AffineSpans& spans) {
    const TexelRanges texels = texels_of(spans);
    if (texels.t.count() == 2) return in(spans, &ExactRow::v, &Lane::v_fx32, texels.t);
    if (texels.s.count() == 2) return in(spans, &ExactRow::u, &Lane::u_fx32, texels.s);
    return {-1, nullptr, {}};
  }

  // The lanes of either part: in the middle of its texel.
  [[nodiscard]] HWY_INLINE AffineField part(AffineField field, int32_t index) const {
    constexpr int64_t kHalf_fx32 = int64_t{1} << (kLaneFraction - 1);
    field.start.*axis = (int64_t{texel[index]} << kLaneFraction) + kHalf_fx32;
    field.step_x.*axis = 0;
    field.step_y.*axis = 0;
    return field;
  }

 private:
  static HWY_INLINE RowOfTwo in(const AffineSpans& spans, ExactLine ExactRow::*coordinate,
                                int64_t Lane::*axis, const TexelRange& texels) {
    const Span row = spans.batch.span(0);
    const Boundary boundary(spans.exact, coordinate, 0, texels.last, row.left_px, row.row);
    const auto [left_px, left_beyond] = boundary.sides_of(row);
    if (left_beyond) return {left_px, axis, {texels.last, texels.first}};
    return {left_px, axis, {texels.first, texels.last}};
  }
};

// Draws a row, all of its vectors decided: any row, but it pays where near-ties are many.
template <class Pixel, class Address>
HWY_NOINLINE void draw_row_of_ties(const AffineSpans& spans, const Surface& surface) {
  const int32_t window_rows = window_shape(spans.field.step_x, surface.texture).rows;
  if (draw_without_doubt<Pixel, Address>(spans, surface, 0, window_rows)) return;
  AffineBatchTies ties = ties_of(spans);
  Left left;
  const auto draw = [&](const AffineField& field, const Span& part_row) HWY_ATTR {
    const AffineSpans part{spans.batch, field, spans.texels, spans.exact};
    const int32_t part_rows = window_shape(field.step_x, surface.texture).rows;
    const int32_t row = part_row.row, end_px = part_row.right_px;
    for (int32_t px = part_row.left_px; px < end_px;) {
      int32_t count = 0;
      for (; count < Left::kMost && px < end_px; px += kLanes) {
        left.rest[static_cast<size_t>(count++)] = {row, px, end_px};
      }
      left.count = count;
      draw_left<Pixel, Address>(left, part, surface, part_rows, &ties);
    }
  };
  const Span row = spans.batch.span(0);
  const RowOfTwo two = RowOfTwo::of(spans);
  if (two.left_px < 0) return draw(spans.field, row);
  const int32_t middle_px = row.left_px + two.left_px;
  draw(two.part(spans.field, 0), {row.row, row.left_px, middle_px});
  draw(two.part(spans.field, 1), {row.row, middle_px, row.right_px});
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
        batch_ties_(ties_of(spans)) {}

  template <class Pixel, class Address>
  static HWY_NOINLINE bool draw_as(RestDraw* of, const Left& left, int32_t first_index,
                                   int32_t of_vectors) {
    auto* const rest = static_cast<AffineRest*>(of);
    const AffineSpans& spans = rest->spans_;
    const Surface& surface = rest->surface_;
    if (are_many(left.count, of_vectors)) {
      rest->had_many_ = true;
      if (draw_without_doubt<Pixel, Address>(spans, surface, first_index, rest->window_rows_)) {
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
