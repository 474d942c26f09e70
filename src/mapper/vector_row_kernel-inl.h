// Rows' bounds by vectors. Included once for each SIMD target.
#if defined(SELVAGE_VECTOR_ROW_KERNEL_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SELVAGE_VECTOR_ROW_KERNEL_INL_H
#undef SELVAGE_VECTOR_ROW_KERNEL_INL_H
#else
#define SELVAGE_VECTOR_ROW_KERNEL_INL_H
#endif

#include "mapper/span_batch.h"
#include "mapper/vector_kernel-inl.h"

HWY_BEFORE_NAMESPACE();
namespace selvage::mapper::HWY_NAMESPACE {
namespace {

using RowTag = hn::CappedTag<double, kMostDoubles>;
using ColumnTag = hn::Rebind<int32_t, RowTag>;
using Columns = hn::Vec<ColumnTag>;
inline constexpr int32_t kRows = static_cast<int32_t>(hn::MaxLanes(RowTag()));

// Where a line crosses the rows from so many below its first one on.
[[nodiscard]] HWY_INLINE Columns columns_of(const EdgeLine& line, int32_t rows_below) {
  const RowTag d;
  const auto dividend =
      hn::MulAdd(hn::Iota(d, rows_below), hn::Set(d, line.step), hn::Set(d, line.dividend));
  return hn::DemoteTo(ColumnTag(), hn::Floor(hn::Div(dividend, hn::Set(d, line.divisor))));
}

// Makes spans between columns, some rows at a time.
class SpanMaker {
 public:
  HWY_INLINE SpanMaker(int32_t left_px, int32_t right_px, SpanBatch* batch)
      : left_px_(hn::Set(ColumnTag(), left_px)),
        right_px_(hn::Set(ColumnTag(), right_px)),
        widest_px_(hn::Zero(ColumnTag())),
        batch_(batch) {}

  HWY_INLINE void make(int32_t row, Columns a, Columns b) {
    const ColumnTag d;
    const auto left = hn::Max(hn::Min(a, b), left_px_);
    const auto right = hn::Max(hn::Min(hn::Max(a, b), right_px_), left);
    hn::StoreU(left, d, batch_->left_px.data() + row);
    hn::StoreU(right, d, batch_->right_px.data() + row);
    const auto is_row = hn::Lt(hn::Iota(d, row), hn::Set(d, batch_->rows));
    widest_px_ = hn::Max(widest_px_, hn::IfThenElseZero(is_row, hn::Sub(right, left)));
  }

  [[nodiscard]] HWY_INLINE int32_t widest_px() const {
    return hn::GetLane(hn::MaxOfLanes(ColumnTag(), widest_px_));
  }

 private:
  Columns left_px_, right_px_, widest_px_;
  SpanBatch* batch_;
};

HWY_INLINE void find_columns_of(Chain* chain, const SpanBatch& batch, int32_t* first_px) {
  chain->for_each_line(batch.first_row, batch.first_row + batch.rows,
                       [&](const EdgeLine& line, int32_t rows, int32_t first) HWY_ATTR {
                         for (int32_t i = 0; i < rows; i += kRows) {
                           hn::StoreU(columns_of(line, i), ColumnTag(), first_px + first + i);
                         }
                       });
}

HWY_INLINE void find_between_chains(Outline* outline, SpanMaker* spans, SpanBatch* batch) {
  const ColumnTag d;
  find_columns_of(outline->forward(), *batch, batch->left_px.data());
  find_columns_of(outline->backward(), *batch, batch->right_px.data());
  for (int32_t i = 0; i < batch->rows; i += kRows) {
    spans->make(i, hn::LoadU(d, batch->left_px.data() + i),
                hn::LoadU(d, batch->right_px.data() + i));
  }
}

// A triangle's need no walk along its edges: all of them are followed through all rows.
HWY_INLINE void find_in_triangle(const TriangleLines& lines, SpanMaker* spans, int32_t rows) {
  const ColumnTag d;
  for (int32_t i = 0; i < rows; i += kRows) {
    const auto is_upper = hn::Lt(hn::Iota(d, i), hn::Set(d, lines.upper_rows));
    spans->make(i, columns_of(lines.whole, i),
                hn::IfThenElse(is_upper, columns_of(lines.upper, i), columns_of(lines.lower, i)));
  }
}

void find_spans(Outline* outline, int32_t left_px, int32_t right_px, SpanBatch* batch) {
  SpanMaker spans(left_px, right_px, batch);
  if (outline->is_triangle()) {
    find_in_triangle(outline->lines_from(batch->first_row), &spans, batch->rows);
  } else {
    find_between_chains(outline, &spans, batch);
  }
  batch->widest_px = spans.widest_px();
}

}  // namespace
}  // namespace selvage::mapper::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
