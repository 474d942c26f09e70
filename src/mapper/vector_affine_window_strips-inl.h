// Narrow affine spans by windows, those of some rows found at once. Included once for each SIMD
// target.
#if defined(SELVAGE_VECTOR_AFFINE_WINDOW_STRIPS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SELVAGE_VECTOR_AFFINE_WINDOW_STRIPS_INL_H
#undef SELVAGE_VECTOR_AFFINE_WINDOW_STRIPS_INL_H
#else
#define SELVAGE_VECTOR_AFFINE_WINDOW_STRIPS_INL_H
#endif

#include "mapper/vector_affine_strip-inl.h"
#include "mapper/vector_affine_windows-inl.h"

HWY_BEFORE_NAMESPACE();
namespace selvage::mapper::HWY_NAMESPACE {
namespace {

// A vector of each row of a batch, and its window.
struct StripWindows {
  FoundWindows found;
  HWY_ALIGN int32_t from_px[kRowsPerBatch + kLanes], count_px[kRowsPerBatch + kLanes];

  // Of these rows.
  template <class Finder>
  HWY_INLINE void find(const Finder& finder, const SpanBatch& batch, const RowBlock& rows,
                       int32_t right_by_px, Lane anchor, const AffineField& field) {
    for_strip(
        batch, rows, right_by_px, anchor, field,
        [&](int32_t row, const StripEnds& ends, const WideLanes& u, const WideLanes& v) HWY_ATTR
        __attribute__((always_inline)) {
          hn::StoreU(ends.from_px, D32(), from_px + row);
          hn::StoreU(ends.count_px, D32(), count_px + row);
          finder.find(u, v, row, &found);
        });
  }
};

// Draws a strip, and puts down the vectors that are left.
template <class Pixel, class Draw>
HWY_INLINE int32_t draw_strip(const Draw& by, const StripWindows& strip, const RowBlock& rows,
                              const SpanBatch& batch, const selvage_image& target, Left* left) {
  char* row = static_cast<char*>(target.pixels) + (batch.first_row + rows.first) * target.pitch;
  int32_t left_count = 0;
  for (int32_t i = rows.first; i < rows.end; ++i) {
    const int32_t from_px = strip.from_px[i], count_px = strip.count_px[i];
    Pixel* const to = reinterpret_cast<Pixel*>(row) + from_px;
    if (HWY_UNLIKELY(!by.draw(strip.found, i, count_px, to)) && count_px > 0) {
      left->rest[static_cast<size_t>(left_count++)] = {batch.first_row + i, from_px,
                                                       from_px + count_px};
    }
    row += target.pitch;
  }
  return left_count;
}

// Draws all vectors but for those that do not lie in a window: where some of a strip are left,
// calls draw_left(first_row, of_vectors) with their number and the row of the batch above which all
// is drawn. Ends where that returns false.
template <class DrawLeft>
struct WindowStrips {
  const AffineSpans& spans;
  const Surface& surface;
  bool inside;
  Left* left;
  const DrawLeft& draw_left;

  template <class Pixel, class InWindow, int kColumnBits, int32_t kRows>
  HWY_NOINLINE void draw(const WindowShape& shape) const {
    using Draw = WindowDraw<Pixel, InWindow, kColumnBits, kRows>;
    static_assert(Left::kMost >= kRowsPerBatch);
    const Draw by(spans, surface, shape.rows);
    const WindowFinder<typename Draw::Coarse> finder(surface, shape, inside);
    const AffineField field = spans.field;
    const SpanBatch& batch = spans.batch;
    const Lane anchor = plus(field.at(0, batch.first_row), 1, by.to_anchor());
    StripWindows strip;
    for_each_strip(
        batch, rows_per_block(surface.target.pitch),
        [&](const RowBlock& block, const RowBlock& rows, int32_t right_by_px) HWY_ATTR
        __attribute__((always_inline)) {
          strip.find(finder, batch, rows, right_by_px, anchor, field);
          left->count = draw_strip<Pixel>(by, strip, rows, batch, surface.target, left);
          return HWY_LIKELY(left->count == 0) || draw_left(block.first, rows.end - rows.first);
        });
  }
};

}  // namespace
}  // namespace selvage::mapper::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
