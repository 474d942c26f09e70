// Affine spans of a polygon whose texels lie in one window. Included once for each SIMD target.
#if defined(SELVAGE_VECTOR_AFFINE_WINDOW_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SELVAGE_VECTOR_AFFINE_WINDOW_INL_H
#undef SELVAGE_VECTOR_AFFINE_WINDOW_INL_H
#else
#define SELVAGE_VECTOR_AFFINE_WINDOW_INL_H
#endif

#include "mapper/vector_affine_exact-inl.h"
#include "mapper/vector_affine_strip-inl.h"

HWY_BEFORE_NAMESPACE();
namespace selvage::mapper::HWY_NAMESPACE {
namespace {

// Draws vectors from one window, and keeps what the lanes of pixels lack changes in them. The
// window and the constants of lanes are copies: as such they stay in registers, for no store can
// change them.
template <class Pixel, class Batch, class OneWindow>
struct WindowPainter {
  OneWindow window;
  Batch batch;
  V32 changed = hn::Zero(D32());

  HWY_INLINE void draw(int32_t u_fx16, int32_t v_fx16, int32_t count_px, Pixel* to) {
    changed = draw_first(window, batch, batch.lanes_from(u_fx16, v_fx16), count_px, changed, to);
  }
};

// A vector of each row of a batch.
struct StripVectors {
  HWY_ALIGN int32_t u_fx16[kRowsPerBatch + kLanes], v_fx16[kRowsPerBatch + kLanes];
  HWY_ALIGN int32_t from_px[kRowsPerBatch + kLanes], count_px[kRowsPerBatch + kLanes];

  HWY_INLINE void put(int32_t row, const StripEnds& ends, const WideLanes& u, const WideLanes& v) {
    const D32 d;
    hn::StoreU(u.floors_fx16(), d, u_fx16 + row);
    hn::StoreU(v.floors_fx16(), d, v_fx16 + row);
    hn::StoreU(ends.from_px, d, from_px + row);
    hn::StoreU(ends.count_px, d, count_px + row);
  }
};

template <class Pixel, class Painter>
HWY_INLINE void draw_strip(const StripVectors& vectors, const RowBlock& rows, char* row,
                           ptrdiff_t pitch, Painter* painter) {
  for (ptrdiff_t i = rows.first; i < rows.end; ++i) {
    painter->draw(vectors.u_fx16[i], vectors.v_fx16[i], vectors.count_px[i],
                  reinterpret_cast<Pixel*>(row) + vectors.from_px[i]);
    row += pitch;
  }
}

// `first`: the lane of the vector that begins in column 0 of the batch's first row.
template <class Pixel, class Painter>
[[nodiscard]] HWY_INLINE V32 draw_strips(Painter painter, const SpanBatch& batch, Lane first,
                                         const AffineField& field, const selvage_image& target) {
  const ptrdiff_t pitch = target.pitch;
  char* const first_row = static_cast<char*>(target.pixels) + batch.first_row * pitch;
  StripVectors vectors;
  for_each_strip(
      batch, rows_per_block(pitch),
      [&](const RowBlock& /*block*/, const RowBlock& rows, int32_t right_by_px) HWY_ATTR
      __attribute__((always_inline)) {
        for_strip(
            batch, rows, right_by_px, first, field,
            [&](int32_t row, const StripEnds& ends, const WideLanes& u, const WideLanes& v) HWY_ATTR
            __attribute__((always_inline)) { vectors.put(row, ends, u, v); });
        draw_strip<Pixel>(vectors, rows, first_row + rows.first * pitch, pitch, &painter);
        return true;
      });
  return painter.changed;
}

// Returns, in the high bits of each lane, whether one of its pixels is a near-tie.
template <class Pixel, class Address, class OneWindow>
[[nodiscard]] HWY_INLINE V32 draw_from(const OneWindow& window, const AffineSpans& spans,
                                       const Surface& surface) {
  using Batch = AffineBatch<Address>;
  const SpanBatch& rows = spans.batch;
  const AffineField& field = spans.field;
  const WindowPainter<Pixel, Batch, OneWindow> painter{window, Batch(spans, surface)};
  const Lane first = painter.batch.anchor(field.at(0, rows.first_row));
  return draw_strips<Pixel>(painter, rows, plus(first, -1, window.origin()), field, surface.target);
}

// Draws a batch from one window; of an address mode it takes lanes alone, for which any will do.
template <class Pixel>
struct AffineFromWindow {
  const AffineSpans& spans;
  const Surface& surface;
  V32* changed;  // by near-ties

  template <class OneWindow>
  [[nodiscard]] HWY_INLINE bool operator()(const OneWindow& window) const {
    *changed = draw_from<Pixel, Addressed<InsideVector>>(window, spans, surface);
    return true;
  }
};

// Draws a batch, if one window holds its texels and no pixel is a near-tie.
template <class Pixel, class Address>
[[nodiscard]] HWY_INLINE InOneWindow draw_one_window(const AffineSpans& spans,
                                                     const Surface& surface) {
  if (!pays_one_window(spans.batch)) return InOneWindow::kNotDrawn;
  V32 changed;
  if (!with_one_window<Pixel, Address>(spans.texels, surface.texture,
                                       AffineFromWindow<Pixel>{spans, surface, &changed})) {
    return InOneWindow::kNotDrawn;
  }
  return in_one_window(changed, spans.batch.widest_px);
}

}  // namespace
}  // namespace selvage::mapper::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
