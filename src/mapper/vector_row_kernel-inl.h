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

HWY_INLINE void find_columns(const EdgeLine& line, int32_t rows, int32_t* HWY_RESTRICT first_px) {
  const hn::CappedTag<double, kMostDoubles> d;
  const hn::Rebind<int32_t, decltype(d)> column;
  constexpr int32_t kRows = static_cast<int32_t>(hn::MaxLanes(d));
  const auto divisor = hn::Set(d, line.divisor);
  auto dividend =
      hn::Add(hn::Mul(hn::Iota(d, 0.0), hn::Set(d, line.step)), hn::Set(d, line.dividend));
  for (int32_t i = 0; i < rows; i += kRows) {
    const auto quotient = hn::Floor(hn::Div(dividend, divisor));
    hn::StoreU(hn::DemoteTo(column, quotient), column, first_px + i);
    dividend = hn::Add(dividend, hn::Set(d, kRows * line.step));
  }
}

HWY_INLINE void make_spans(int32_t left_px, int32_t right_px, SpanBatch* batch) {
  const hn::CappedTag<int32_t, kMostDoubles> d;
  constexpr int32_t kRows = static_cast<int32_t>(hn::MaxLanes(d));
  int32_t* const left_of = batch->left_px.data();
  int32_t* const right_of = batch->right_px.data();
  auto widest = hn::Zero(d);
  for (int32_t i = 0; i < batch->rows; i += kRows) {
    const auto a = hn::LoadU(d, left_of + i), b = hn::LoadU(d, right_of + i);
    const auto left = hn::Max(hn::Min(a, b), hn::Set(d, left_px));
    const auto right = hn::Max(hn::Min(hn::Max(a, b), hn::Set(d, right_px)), left);
    hn::StoreU(left, d, left_of + i);
    hn::StoreU(right, d, right_of + i);
    const auto is_row = hn::Lt(hn::Iota(d, 0), hn::Set(d, batch->rows - i));
    widest = hn::Max(widest, hn::IfThenElseZero(is_row, hn::Sub(right, left)));
  }
  batch->widest_px = hn::GetLane(hn::MaxOfLanes(d, widest));
}

HWY_INLINE void find_columns_of(Chain* chain, const SpanBatch& batch, int32_t* first_px) {
  chain->for_each_line(batch.first_row, batch.first_row + batch.rows,
                       [&](const EdgeLine& line, int32_t rows, int32_t first)
                           HWY_ATTR { find_columns(line, rows, first_px + first); });
}

void find_spans(Chain* forward, Chain* backward, int32_t left_px, int32_t right_px,
                SpanBatch* batch) {
  find_columns_of(forward, *batch, batch->left_px.data());
  find_columns_of(backward, *batch, batch->right_px.data());
  make_spans(left_px, right_px, batch);
}

}  // namespace
}  // namespace selvage::mapper::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
