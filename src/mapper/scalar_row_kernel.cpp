// Rows' bounds by plain arithmetic.
#include <algorithm>

#include "mapper/span_batch.h"

namespace selvage::mapper {
namespace {

// The quotient's floor and remainder, and those of the step, make each row from the one before:
// by additions, and without a branch, for carries come as good as at random.
void find_columns(const EdgeLine& line, int32_t rows, int32_t* first_px) {
  const auto divisor = static_cast<int64_t>(line.divisor);
  const auto column = floor_quotient(line.dividend, line.divisor);
  const auto step = floor_quotient(line.step, line.divisor);
  int64_t column_px = column;
  int64_t remainder = static_cast<int64_t>(line.dividend) - column * divisor;
  const int64_t step_remainder = static_cast<int64_t>(line.step) - step * divisor;
  for (int32_t i = 0; i < rows; ++i) {
    first_px[i] = static_cast<int32_t>(column_px);
    remainder += step_remainder - divisor;
    const int64_t borrow = remainder >> 63;  // -1 where there is no carry
    remainder += borrow & divisor;
    column_px += step + 1 + borrow;
  }
}

void make_spans(int32_t left_px, int32_t right_px, SpanBatch* batch) {
  batch->widest_px = 0;
  for (size_t i = 0; i < static_cast<size_t>(batch->rows); ++i) {
    const int32_t a = batch->left_px[i], b = batch->right_px[i];
    const int32_t left = std::max(std::min(a, b), left_px);
    const int32_t right = std::max(std::min(std::max(a, b), right_px), left);
    batch->left_px[i] = left;
    batch->right_px[i] = right;
    batch->widest_px = std::max(batch->widest_px, right - left);
  }
}

void find_columns_of(Chain* chain, const SpanBatch& batch, int32_t* first_px) {
  chain->for_each_line(batch.first_row, batch.first_row + batch.rows,
                       [&](const EdgeLine& line, int32_t rows, int32_t first) {
                         find_columns(line, rows, first_px + first);
                       });
}

}  // namespace

void find_spans_scalar(Outline* outline, int32_t left_px, int32_t right_px, SpanBatch* batch) {
  auto& [forward, backward] = outline->chains();
  find_columns_of(&forward, *batch, batch->left_px.data());
  find_columns_of(&backward, *batch, batch->right_px.data());
  make_spans(left_px, right_px, batch);
}

}  // namespace selvage::mapper
