// From columns to spans, by each kernel: the same, and the widest of them.
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "mapper/span_batch.h"
#include "mapper/vector_kernel.h"
#include "spec/random.h"
#include "tests/kernel_support.h"

namespace selvage::mapper {
namespace {

[[nodiscard]] std::vector<const RowKernel*> row_kernels() {
  std::vector<const RowKernel*> kernels = {&kScalarRowKernel};
  for (const selvage_kernel kernel : usable_kernels()) {
    const Kernels* const vectors = vector_kernels(kernel, SELVAGE_FILTER_NEAREST);
    if (vectors != nullptr) kernels.push_back(&vectors->rows);
  }
  return kernels;
}

// What lies beyond the rows is wider than they are, and means nothing.
TEST(RowKernel, MakesSpansAndFindsTheWidest) {
  spec::Random random(4);
  for (int i = 0; i < 2000; ++i) {
    SpanBatch batch;
    batch.first_row = 5;
    batch.rows = random.in(1, kRowsPerBatch + 1);
    const int32_t left_px = random.in(-5, 40), right_px = left_px + random.in(1, 400);
    for (size_t k = 0; k < batch.left_px.size(); ++k) {
      const bool is_row = k < static_cast<size_t>(batch.rows);
      batch.left_px[k] = is_row ? random.in(-50, 300) : -1000;
      batch.right_px[k] = is_row ? random.in(-50, 300) : 1000;
    }
    int32_t widest_px = 0;
    std::vector<Span> wanted;
    for (int32_t row = 0; row < batch.rows; ++row) {
      const auto [left, right] = std::minmax(batch.left_px[static_cast<size_t>(row)],
                                             batch.right_px[static_cast<size_t>(row)]);
      Span span{5 + row, std::max(left, left_px), std::min(right, right_px)};
      span.right_px = std::max(span.right_px, span.left_px);
      widest_px = std::max(widest_px, span.width_px());
      wanted.push_back(span);
    }
    for (const RowKernel* const kernel : row_kernels()) {
      SpanBatch spans = batch;
      kernel->make_spans(left_px, right_px, &spans);
      ASSERT_EQ(spans.widest_px, widest_px) << i;
      for (int32_t row = 0; row < batch.rows; ++row) {
        const Span span = spans.span(row), want = wanted[static_cast<size_t>(row)];
        ASSERT_EQ(span.row, want.row) << i;
        ASSERT_EQ(span.left_px, want.left_px) << i << ", row " << row;
        ASSERT_EQ(span.right_px, want.right_px) << i << ", row " << row;
      }
    }
  }
}

}  // namespace
}  // namespace selvage::mapper
