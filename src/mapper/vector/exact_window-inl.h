// Near-ties of a plane's narrow rows whose texels lie in one window: exact quotients, a vector of
// columns at a time, from row to row. Included once for each SIMD target.
#if defined(SELVAGE_VECTOR_EXACT_WINDOW_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SELVAGE_VECTOR_EXACT_WINDOW_INL_H
#undef SELVAGE_VECTOR_EXACT_WINDOW_INL_H
#else
#define SELVAGE_VECTOR_EXACT_WINDOW_INL_H
#endif

#include "mapper/vector/affine_exact-inl.h"
#include "mapper/vector/one_window-inl.h"

HWY_BEFORE_NAMESPACE();
namespace selvage::mapper::HWY_NAMESPACE {
namespace {

// The rows of a block that have pixels in a strip, a vector of columns, and maybe some between that
// have none there.
[[nodiscard]] HWY_NOINLINE RowBlock rows_in_strip(const SpanBatch& batch, const RowBlock& block,
                                                  int32_t strip_px) {
  const D32 d;
  const V32 left = hn::Set(d, strip_px), right = hn::Set(d, strip_px + kLanes);
  return rows_where(block, [&](int32_t row) HWY_ATTR {
    const V32 from = hn::Max(hn::LoadU(d, batch.left_px.data() + row), left);
    const V32 to = hn::Min(hn::LoadU(d, batch.right_px.data() + row), right);
    return hn::Lt(from, to);
  });
}

// The columns of a block.
[[nodiscard]] HWY_NOINLINE Span columns_of(const SpanBatch& batch, const RowBlock& rows) {
  Span columns{batch.first_row, INT32_MAX, 0};
  for (int32_t i = rows.first; i < rows.end; ++i) {
    const Span span = batch.span(i);
    if (span.empty()) continue;
    columns.left_px = HWY_MIN(columns.left_px, span.left_px);
    columns.right_px = HWY_MAX(columns.right_px, span.right_px);
  }
  return columns;
}

// A vector's lanes from one on, so that it is the first.
[[nodiscard]] HWY_INLINE V32 lanes_from(int32_t lane, V32 of) {
#if HWY_TARGET == HWY_AVX3
  return V32{_mm512_permutexvar_epi32(hn::Iota(D32(), lane).raw, of.raw)};
#elif HWY_TARGET == HWY_AVX2
  return V32{_mm256_permutevar8x32_epi32(of.raw, hn::Iota(D32(), lane).raw)};
#else
  static_cast<void>(lane);
  return of;  // there are no windows
#endif
}

// Both coordinates of a vector of pixels.
struct ExactTexels {
  Quotients u, v;

  // Lanes without a fraction.
  [[nodiscard]] HWY_INLINE LaneVectors lanes() const { return {u.whole, v.whole}; }
};

// Those of a plane's batch.
class ExactPlane {
 public:
  explicit HWY_NOINLINE ExactPlane(const AffineSpans& spans)
      : ExactPlane(spans.field, spans.batch.first_row,
                   spans.exact.rows_from(spans.field.first_px, spans.batch.first_row)) {}

  // From a pixel of a row on, counted from a texel.
  [[nodiscard]] HWY_NOINLINE ExactTexels from(int32_t px, int32_t index, Lane origin) const {
    const auto at = [&](const ExactCoordinate& of, int64_t lane_fx32,
                        int64_t origin_fx32) HWY_ATTR {
      Quotients texels = of.from(px - field_.first_px, index, lane_fx32);
      texels.whole = hn::Sub(texels.whole, hn::Set(D32(), floor_texel(origin_fx32)));
      return texels;
    };
    const Lane lane = field_.at(px, first_row_ + index);
    return {at(u_, lane.u_fx32, origin.u_fx32), at(v_, lane.v_fx32, origin.v_fx32)};
  }
  [[nodiscard]] HWY_INLINE ExactTexels below(const ExactTexels& row) const {
    return {down_u_.of(row.u), down_v_.of(row.v)};
  }

 private:
  HWY_INLINE ExactPlane(const AffineField& field, int32_t first_row, const ExactRows& rows)
      : field_(field),
        first_row_(first_row),
        u_(rows.row.u, rows.below.u.start, divisor_of(rows), field.step_x.u_fx32),
        v_(rows.row.v, rows.below.v.start, divisor_of(rows), field.step_x.v_fx32),
        down_u_(u_.step_down(field.step_y.u_fx32)),
        down_v_(v_.step_down(field.step_y.v_fx32)) {}

  static HWY_INLINE uint64_t divisor_of(const ExactRows& rows) {
    return static_cast<uint64_t>(rows.row.d.start);  // as has_quotients() of a plane
  }

  AffineField field_;
  int32_t first_row_;
  ExactCoordinate u_, v_;
  QuotientSum down_u_, down_v_;
};

// Whether strips of so many columns cost less than what decides near-ties otherwise: many rows have
// pixels in each. That also keeps lanes within 32 bits of texels wherever strips begin: a plane's
// steps are small where one window holds the texels of so wide rows, and strips begin near them.
[[nodiscard]] HWY_INLINE bool pays_exact_window(const SpanBatch& batch, const Span& columns) {
  return batch.widest_px > kLanes / 2 && columns.width_px() <= 2 * batch.widest_px + kLanes;
}

// Rows of a plane's batch, if that pays.
template <class Pixel>
struct ExactFromWindow {
  static constexpr bool kTwoSizes = true;  // it is seldom asked for

  const AffineSpans& spans;
  const Surface& surface;
  RowBlock rows;

  template <class OneWindow>
  [[nodiscard]] HWY_INLINE bool operator()(const OneWindow& window) const {
    const Span columns = columns_of(spans.batch, rows);
    if (!pays_exact_window(spans.batch, columns)) return false;
    const ExactPlane plane(spans);
    for (int32_t px = columns.left_px; px < columns.right_px; px += kLanes) {
      const RowBlock strip = rows_in_strip(spans.batch, rows, px);
      ExactTexels texels = plane.from(px, strip.first, window.origin());
      for (int32_t i = strip.first; i < strip.end; ++i) {
        draw_part(spans.batch.span(i), px, window.template texels<0>(texels.lanes()));
        texels = plane.below(texels);
      }
    }
    return true;
  }

 private:
  // The pixels of a span in a strip.
  HWY_INLINE void draw_part(const Span& span, int32_t strip_px, V32 pixels) const {
    const int32_t from_px = HWY_MAX(span.left_px, strip_px);
    const int32_t count_px = HWY_MIN(span.right_px, strip_px + kLanes) - from_px;
    if (count_px <= 0) return;
    auto* const to =
        reinterpret_cast<Pixel*>(first_pixel(surface, {span.row, from_px, from_px + count_px}));
    store_pixels(lanes_from(from_px - strip_px, pixels), count_px, to);
  }
};

// Draws the rows of a plane's batch from an index on, if one window holds its texels and it pays.
template <class Pixel, class Address>
[[nodiscard]] HWY_INLINE bool draw_exactly_from_window(const AffineSpans& spans,
                                                       const Surface& surface,
                                                       int32_t first_index) {
  const RowBlock rows{first_index, spans.batch.rows, spans.batch.widest_px};
  return pays_one_window(spans.batch) &&
         with_one_window<Pixel, Address>(spans.texels, surface.texture,
                                         ExactFromWindow<Pixel>{spans, surface, rows});
}

}  // namespace
}  // namespace selvage::mapper::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
