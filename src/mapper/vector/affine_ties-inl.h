// Affine spans of one map with many near-ties among them. Included once for each SIMD target.
#if defined(SELVAGE_VECTOR_AFFINE_TIES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SELVAGE_VECTOR_AFFINE_TIES_INL_H
#undef SELVAGE_VECTOR_AFFINE_TIES_INL_H
#else
#define SELVAGE_VECTOR_AFFINE_TIES_INL_H
#endif

#include "mapper/vector/affine_lanes-inl.h"
#include "mapper/vector/boundaries-inl.h"
#include "mapper/vector/exact_window-inl.h"
#include "mapper/vector/tie_columns-inl.h"

HWY_BEFORE_NAMESPACE();
namespace selvage::mapper::HWY_NAMESPACE {
namespace {

// The narrow rows of a plane from an index in the batch on.
template <class Pixel, class Address>
HWY_INLINE void draw_columns(const AffineSpans& spans, const Surface& surface,
                             int32_t first_index) {
  static_assert(kPlaneAreaBits + kTexelFraction - kLeastSpareBits < 62, "one limb is enough");
  const AffineField& field = spans.field;
  const ExactRow row = spans.exact.row_from(field.first_px, spans.batch.first_row);
  const auto divisor = static_cast<uint64_t>(row.d.start);  // as has_quotients() of a plane
  const auto step = [&](const ExactLine& n, int64_t step_fx32) HWY_ATTR {
    return QuotientSum(quotient_from(n.step, divisor, floor_texel(step_fx32)), divisor);
  };
  const PlaneSteps steps{step(row.u, field.step_x.u_fx32), step(row.v, field.step_x.v_fx32)};
  const DecidedColumnsOf<PlaneColumns> first(LowLanes(lack_fx16(field.margin_fx32)),
                                             PlaneColumns(field));
  draw_columns<Pixel, Address>(
      spans.batch, first_index, spans.exact, surface,
      [&](const ColumnTies<OneLimbColumn>& ties, int32_t first_row, V32 px)
          HWY_ATTR { return QuotientColumns(first(ties, first_row, px), steps); });
}

// Of a single row, that may be the only one with its map, those under its ends and between them.
[[nodiscard]] HWY_INLINE TexelRanges texels_of(const AffineSpans& spans) {
  TexelRanges texels(spans.texels);
  if (spans.batch.rows > 1) return texels;
  const Span row = spans.batch.span(0);
  const Lane a = spans.field.at(row.left_px, row.row),
             b = spans.field.at(row.right_px - 1, row.row);
  const auto between = [&](int64_t from_fx32, int64_t to_fx32) {
    return TexelRange{floor_texel(HWY_MIN(from_fx32, to_fx32)),
                      floor_texel(HWY_MAX(from_fx32, to_fx32) + spans.field.margin_fx32)};
  };
  texels.s = between(a.u_fx32, b.u_fx32);
  texels.t = between(a.v_fx32, b.v_fx32);
  return texels;
}

// Draws rows with many near-ties, from an index in the batch on: false where it costs less to
// decide vectors one by one.
template <class Pixel, class Address>
[[nodiscard]] HWY_NOINLINE bool draw_near_ties(const AffineSpans& spans, const Surface& surface,
                                               int32_t first_index) {
  const TexelRanges texels = texels_of(spans);
  const bool has_columns = pays_columns(spans.batch);
  if (!(has_columns && beat_boundaries(spans.batch, texels)) &&
      draw_between_boundaries<Pixel, Address>(spans.batch, texels, spans.exact, 0, surface)) {
    return true;
  }
  if (draw_exactly_from_window<Pixel, Address>(spans, surface, first_index)) return true;
  if (has_columns) draw_columns<Pixel, Address>(spans, surface, first_index);
  return has_columns;
}

}  // namespace
}  // namespace selvage::mapper::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
