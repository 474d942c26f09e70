// Affine spans of a polygon whose texels lie in one window. Included once for each SIMD target.
#if defined(SELVAGE_VECTOR_AFFINE_WINDOW_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SELVAGE_VECTOR_AFFINE_WINDOW_INL_H
#undef SELVAGE_VECTOR_AFFINE_WINDOW_INL_H
#else
#define SELVAGE_VECTOR_AFFINE_WINDOW_INL_H
#endif

#include "mapper/vector_affine_exact-inl.h"
#include "mapper/vector_affine_lanes-inl.h"
#include "mapper/vector_one_window-inl.h"

HWY_BEFORE_NAMESPACE();
namespace selvage::mapper::HWY_NAMESPACE {
namespace {

// Modulo 2^64.
[[nodiscard]] HWY_INLINE Lane plus(Lane lane, int32_t steps, Lane step) {
  const auto sum = [steps](int64_t from, int64_t by) {
    return static_cast<int64_t>(static_cast<uint64_t>(from) +
                                static_cast<uint64_t>(steps) * static_cast<uint64_t>(by));
  };
  return {sum(lane.u_fx32, step.u_fx32), sum(lane.v_fx32, step.v_fx32)};
}

// All of a batch that has a vector a row, maybe of no pixels. Returns what the lanes of pixels lack
// changes in them. The window and the constants of lanes are copies: as such they stay in
// registers, for no store can change them.
template <class Pixel, class Batch, class OneWindow>
[[nodiscard]] HWY_INLINE V32 draw_rows(OneWindow window, Batch batch, const AffineSpans& spans,
                                       const selvage_image& target) {
  const D32 d;
  const Lane step_x = spans.field.step_x, step_y = spans.field.step_y;
  const int32_t* const left_px = spans.batch.left_px.data();
  const int32_t* const right_px = spans.batch.right_px.data();
  const ptrdiff_t pitch = target.pitch;
  Lane at_row = batch.anchor(spans.field.at(0, spans.batch.first_row));
  char* row = static_cast<char*>(target.pixels) + spans.batch.first_row * pitch;
  V32 changed = hn::Zero(d);
  for (int32_t i = 0, rows = spans.batch.rows; i < rows; ++i) {
    const int32_t px = left_px[i], count_px = right_px[i] - px;
    const LaneVectors lanes = batch.lanes_from(plus(at_row, px, step_x));
    const auto is_pixel = hn::Gt(hn::Set(d, count_px), hn::Iota(d, 0));
    changed = hn::IfThenElse(is_pixel, hn::Or(changed, batch.changes(lanes)), changed);
    store_first(is_pixel, window.texels(lanes), count_px, reinterpret_cast<Pixel*>(row) + px);
    at_row = plus(at_row, 1, step_y);
    row += pitch;
  }
  return changed;
}

// The vectors of a batch of narrow spans, row by row, in a list: where rows end is seldom foreseen,
// and of a list only the end has to be guessed.
struct VectorList {
  static constexpr int32_t kMostPerRow = kMostOneWindow_px / kLanes;
  static constexpr size_t kMost = (kRowsPerBatch + 1) * kMostPerRow;

  // kMostOneWindow_px times a row, and how far right of its left end the vector begins.
  std::array<int32_t, kMost> place;
  int32_t count;

  HWY_INLINE explicit VectorList(const SpanBatch& batch) {
    int32_t end = 0;
    for (int32_t i = 0; i < batch.rows; ++i) {
      store_row(i * kMostOneWindow_px, place.data() + end);
      end += (batch.span(i).width_px() + (kLanes - 1)) / kLanes;
    }
    count = end;
  }

 private:
  static HWY_INLINE void store_row(int32_t row_place, int32_t* to) {
    const hn::CappedTag<int32_t, kMostPerRow> d;
    constexpr auto kPart =
        static_cast<int32_t>(hn::MaxLanes(hn::CappedTag<int32_t, kMostPerRow>()));
    for (int32_t k = 0; k < kMostPerRow; k += kPart) {
      const auto right_by = hn::Mul(hn::Iota(d, k), hn::Set(d, kLanes));
      hn::StoreU(hn::Add(hn::Set(d, row_place), right_by), d, to + k);
    }
  }
};

// The same of a batch that has several vectors a row.
template <class Pixel, class Batch, class OneWindow>
[[nodiscard]] HWY_INLINE V32 draw_list(OneWindow window, Batch batch, const AffineSpans& spans,
                                       const selvage_image& target) {
  const D32 d;
  const SpanBatch& rows = spans.batch;
  const VectorList list(rows);
  std::array<Lane, kRowsPerBatch> anchors;
  std::array<Pixel*, kRowsPerBatch> pixels;
  const Lane step_x = spans.field.step_x;
  Lane at_row = batch.anchor(spans.field.at(0, rows.first_row));
  char* row = static_cast<char*>(target.pixels) + rows.first_row * target.pitch;
  for (size_t i = 0; i < static_cast<size_t>(rows.rows); ++i) {
    anchors[i] = plus(at_row, rows.left_px[i], step_x);
    pixels[i] = reinterpret_cast<Pixel*>(row) + rows.left_px[i];
    at_row = plus(at_row, 1, spans.field.step_y);
    row += target.pitch;
  }
  V32 changed = hn::Zero(d);
  for (size_t k = 0; k < static_cast<size_t>(list.count); ++k) {
    const auto place = static_cast<uint32_t>(list.place[k]);
    const size_t i = place / kMostOneWindow_px;
    const auto right_by_px = static_cast<int32_t>(place % kMostOneWindow_px);
    const int32_t count_px = rows.right_px[i] - rows.left_px[i] - right_by_px;
    const LaneVectors lanes = batch.lanes_from(plus(anchors[i], right_by_px, step_x));
    const auto is_pixel = hn::Gt(hn::Set(d, count_px), hn::Iota(d, 0));
    changed = hn::IfThenElse(is_pixel, hn::Or(changed, batch.changes(lanes)), changed);
    store_first(is_pixel, window.texels(lanes), count_px, pixels[i] + right_by_px);
  }
  return changed;
}

// Returns, in the high bits of each lane, whether one of its pixels is a near-tie.
template <class Pixel, class Address, class OneWindow>
[[nodiscard]] HWY_INLINE V32 draw_from(const OneWindow& window, const AffineSpans& spans,
                                       const Surface& surface) {
  const AffineBatch<Address> batch(spans, surface);
  return spans.batch.widest_px <= kLanes ? draw_rows<Pixel>(window, batch, spans, surface.target)
                                         : draw_list<Pixel>(window, batch, spans, surface.target);
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

// What became of a batch: whether it is drawn or, if not, whether near-ties are why, and many.
enum class InOneWindow { kDrawn, kNotDrawn, kManyNearTies };

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
  if (!any_bits(changed, ~0xFFFF)) return InOneWindow::kDrawn;
  const auto near = hn::Ne(hn::ShiftRight<kTexelFraction>(changed), hn::Zero(D32()));
  return hn::CountTrue(D32(), near) < kLeastNear ? InOneWindow::kNotDrawn
                                                 : InOneWindow::kManyNearTies;
}

}  // namespace
}  // namespace selvage::mapper::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
