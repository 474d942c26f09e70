// Rows' bounds by vectors. Included once for each SIMD target.
#if defined(SELVAGE_VECTOR_ROW_KERNEL_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SELVAGE_VECTOR_ROW_KERNEL_INL_H
#undef SELVAGE_VECTOR_ROW_KERNEL_INL_H
#else
#define SELVAGE_VECTOR_ROW_KERNEL_INL_H
#endif

#include "mapper/span_batch.h"
#include "mapper/vector/edge_lines-inl.h"
#include "mapper/vector/entries-inl.h"
#include "mapper/vector/pair-inl.h"

HWY_BEFORE_NAMESPACE();
namespace selvage::mapper::HWY_NAMESPACE {
namespace {

[[nodiscard]] HWY_INLINE LineVectors vectors_of(const EdgeLine& line) {
  const RowTag d;
  return {hn::Set(d, line.dividend + kUpToHalf), hn::Set(d, line.step),
          hn::Set(d, 1.0 / line.divisor)};
}

// line_between, by the same numbers: all are whole, and exact in double. Between vertices of one
// height the reciprocal is infinite, and the columns mean nothing.
[[nodiscard]] HWY_INLINE LineVectors lines_between(const selvage_vertex& top,
                                                   const selvage_vertex& bottom, int32_t row) {
  const PairTag pairs;
  const RowTag d;
  const Pair place = xy_of(top);
  const Pair across = hn::Reverse(pairs, hn::Sub(xy_of(bottom), place));  // height, dx
  const Pair right_by = hn::Add(place, hn::Set(pairs, kHalfPixel)),
             below_by = hn::Sub(hn::Set(pairs, centre_fx8(row)), place);
  const Pair terms = hn::Mul(hn::OddEven(below_by, right_by), across);
  const Pair sum = hn::Add(terms, hn::Reverse(pairs, terms));
  const Pair dividend = hn::Add(sum, hn::Set(pairs, kUpToHalf - 1));
  const Pair per_row = hn::Mul(across, hn::Set(pairs, kSubpixels));
  const Pair reciprocal = hn::Div(hn::Set(pairs, 1.0), per_row);
  return {hn::Set(d, hn::GetLane(dividend)), hn::Set(d, hn::GetLane(hn::Reverse(pairs, per_row))),
          hn::Set(d, hn::GetLane(reciprocal))};
}

// Makes spans between columns, some rows at a time.
class SpanMaker {
 public:
  HWY_INLINE SpanMaker(int32_t left_px, int32_t right_px, SpanBatch* batch)
      : left_px_(hn::Set(ColumnTag(), left_px)),
        right_px_(hn::Set(ColumnTag(), right_px)),
        widest_px_(hn::Zero(ColumnTag())),
        rows_(batch->rows),
        batch_(batch) {}

  HWY_INLINE void make(int32_t row, Columns a, Columns b) {
    const ColumnTag d;
    const auto left = hn::Max(hn::Min(a, b), left_px_);
    const auto right = hn::Max(hn::Min(hn::Max(a, b), right_px_), left);
    hn::StoreU(left, d, batch_->left_px.data() + row);
    hn::StoreU(right, d, batch_->right_px.data() + row);
    const auto is_row = hn::Lt(hn::Iota(d, 0), hn::Set(d, rows_ - row));
    widest_px_ = hn::Max(widest_px_, hn::IfThenElseZero(is_row, hn::Sub(right, left)));
  }

  [[nodiscard]] HWY_INLINE int32_t widest_px() const {
    return hn::GetLane(hn::MaxOfLanes(ColumnTag(), widest_px_));
  }

 private:
  Columns left_px_, right_px_, widest_px_;
  int32_t rows_;
  SpanBatch* batch_;
};

HWY_INLINE void find_columns_of(Chain* chain, const SpanBatch& batch, int32_t* first_px) {
  chain->for_each_line(batch.first_row, batch.first_row + batch.rows,
                       [&](const EdgeLine& line, int32_t rows, int32_t first) HWY_ATTR {
                         const LineVectors lines = vectors_of(line);
                         RowNumbers below = hn::Iota(RowTag(), 0);
                         for (int32_t i = 0; i < rows; i += kRows) {
                           hn::StoreU(lines.columns(below), ColumnTag(), first_px + first + i);
                           below = hn::Add(below, hn::Set(RowTag(), kRows));
                         }
                       });
}

HWY_INLINE void find_between_chains(Outline* outline, SpanMaker* spans, SpanBatch* batch) {
  const ColumnTag d;
  auto& [forward, backward] = outline->chains();
  find_columns_of(&forward, *batch, batch->left_px.data());
  find_columns_of(&backward, *batch, batch->right_px.data());
  for (int32_t i = 0; i < batch->rows; i += kRows) {
    spans->make(i, hn::LoadU(d, batch->left_px.data() + i),
                hn::LoadU(d, batch->right_px.data() + i));
  }
}

HWY_INLINE void find_in_triangle(const TriangleCorners& corners, SpanMaker* spans,
                                 const SpanBatch& batch) {
  const RowTag d;
  const auto& [top, middle, bottom] = corners;
  const int32_t row = batch.first_row;
  const TriangleLines lines = {lines_between(top, bottom, row),
                               {lines_between(top, middle, row), lines_between(middle, bottom, row),
                                hn::Set(d, first_centre_px(middle.y) - row)}};
  RowNumbers below = hn::Iota(d, 0);
  for (int32_t i = 0; i < batch.rows; i += kRows) {
    spans->make(i, lines.one_side(below), lines.other_side(below));
    below = hn::Add(below, hn::Set(d, kRows));
  }
}

}  // namespace

void find_spans(Outline* outline, int32_t left_px, int32_t right_px, SpanBatch* batch) {
  SpanMaker spans(left_px, right_px, batch);
  if (outline->is_triangle()) {
    find_in_triangle(outline->corners(), &spans, *batch);
  } else {
    find_between_chains(outline, &spans, batch);
  }
  batch->widest_px = spans.widest_px();
}

}  // namespace selvage::mapper::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
