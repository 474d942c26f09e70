// From edges to the spans of a batch, by each kernel: the same, and the widest of them.
#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <vector>

#include "mapper/span_batch.h"
#include "mapper/vector_kernel.h"
#include "spec/random.h"
#include "tests/kernel_support.h"

namespace selvage::mapper {
namespace {

[[nodiscard]] std::vector<FindSpans> row_kernels() {
  std::vector<FindSpans> kernels = {find_spans_scalar};
  for (const selvage_kernel kernel : usable_kernels()) {
    const Kernels* const vectors = vector_kernels(kernel, SELVAGE_FILTER_NEAREST);
    if (vectors != nullptr) kernels.push_back(vectors->find_spans);
  }
  return kernels;
}

[[nodiscard]] std::vector<selvage_vertex> any_outline(spec::Random& random) {
  const int32_t most_fx8 = random.pick({400, 4000, 60000, 1 << 20});
  std::vector<selvage_vertex> vertices(static_cast<size_t>(random.in(3, 6)));
  for (selvage_vertex& v : vertices) {
    v = {random.in(-most_fx8, most_fx8), random.in(-most_fx8, most_fx8), 0, 0, 1};
  }
  return vertices;
}

// Row by row, by stepping the edges.
[[nodiscard]] std::vector<Span> walked(const Polygon& polygon, const selvage_rect& visible) {
  Chain forward(polygon, Chain::Direction::kForward);
  Chain backward(polygon, Chain::Direction::kBackward);
  std::vector<Span> spans;
  for (int32_t row = std::max(polygon.top_row, visible.top);
       row < std::min(polygon.bottom_row, visible.bottom); ++row) {
    const int32_t a = forward.at_row(row).first_px(), b = backward.at_row(row).first_px();
    const int32_t left_px = std::max(std::min(a, b), visible.left);
    spans.push_back({row, left_px, std::max(std::min(std::max(a, b), visible.right), left_px)});
  }
  return spans;
}

// Most batches end inside of edges that go on to part.
TEST(RowKernel, FindsSpansAndTheWidest) {
  spec::Random random(4);
  int batches = 0;
  while (batches < 4000) {
    const std::vector<selvage_vertex> vertices = any_outline(random);
    Polygon polygon;
    if (examine(vertices, &polygon) != SELVAGE_OK || polygon.top_row >= polygon.bottom_row)
      continue;
    const int32_t left_px = random.in(-300, 300),
                  top = random.in(polygon.top_row - 5, polygon.bottom_row);
    const selvage_rect visible{left_px, top, left_px + random.in(0, 400),
                               top + random.in(1, 2 * kRowsPerBatch)};
    const std::vector<Span> wanted = walked(polygon, visible);
    for (const FindSpans find_spans : row_kernels()) {
      BatchWalk walk(polygon, visible, find_spans);
      SpanBatch batch;
      size_t row = 0;
      while (walk.next(&batch)) {
        ++batches;
        int32_t widest_px = 0;
        for (int32_t i = 0; i < batch.rows; ++i, ++row) {
          ASSERT_LT(row, wanted.size());
          const Span span = batch.span(i), &want = wanted[row];
          ASSERT_EQ(span.row, want.row);
          ASSERT_EQ(span.left_px, want.left_px) << "row " << span.row;
          ASSERT_EQ(span.right_px, want.right_px) << "row " << span.row;
          widest_px = std::max(widest_px, want.width_px());
        }
        ASSERT_EQ(batch.widest_px, widest_px);
      }
      ASSERT_EQ(row, wanted.size());
    }
  }
}

}  // namespace
}  // namespace selvage::mapper
