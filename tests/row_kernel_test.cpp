// From edges to the spans of a batch, by each kernel: the same, and the widest of them.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

#include "mapper/span_batch.h"
#include "mapper/vector/kernel.h"
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

// How many batches the kernel made, each of them as walked and with its widest span.
int expect_as_walked(const Polygon& polygon, const selvage_rect& visible, FindSpans find_spans) {
  const selvage_rect part = part_of(polygon, visible);
  const std::vector<Span> wanted = walked(polygon, part);
  BatchWalk walk(polygon, part, find_spans);
  SpanBatch batch;
  size_t row = 0;
  int batches = 0;
  for (; walk.next(&batch); ++batches) {
    int32_t widest_px = 0;
    for (int32_t i = 0; i < batch.rows; ++i, ++row) {
      const Span span = batch.span(i), want = wanted.at(row);
      EXPECT_EQ(span.row, want.row);
      EXPECT_EQ(span.left_px, want.left_px) << "row " << span.row;
      EXPECT_EQ(span.right_px, want.right_px) << "row " << span.row;
      widest_px = std::max(widest_px, want.width_px());
    }
    EXPECT_EQ(batch.widest_px, widest_px);
  }
  EXPECT_EQ(row, wanted.size());
  return batches;
}

// Most batches end inside of edges that go on to part.
TEST(RowKernel, FindsSpansAndTheWidest) {
  spec::Random random(4);
  int batches = 0;
  while (batches < 4000 && !HasFailure()) {
    const std::vector<selvage_vertex> vertices = any_outline(random);
    Polygon polygon;
    if (examine(vertices, &polygon) != SELVAGE_OK || polygon.top_row >= polygon.bottom_row)
      continue;
    const int32_t left_px = random.in(-300, 300),
                  top = random.in(polygon.top_row - 5, polygon.bottom_row);
    const selvage_rect visible{left_px, top, left_px + random.in(0, 400),
                               top + random.in(1, 2 * kRowsPerBatch)};
    for (const FindSpans find_spans : row_kernels()) {
      batches += expect_as_walked(polygon, visible, find_spans);
    }
  }
}

// From every third row on.
void expect_as_walked_from_any_row(const std::vector<selvage_vertex>& vertices,
                                   const std::vector<FindSpans>& kernels) {
  Polygon polygon;
  ASSERT_EQ(examine(vertices, &polygon), SELVAGE_OK);
  for (int32_t top = polygon.top_row; top < polygon.bottom_row; top += 3) {
    for (const FindSpans find_spans : kernels) {
      expect_as_walked(polygon, {-3, top, 7, polygon.bottom_row}, find_spans);
    }
  }
}

// Vertices on centres and beside them, level edges and none, in either order of any start; what is
// seen of them begins in every row. With a vertex twice they are no triangles, but chains of edges.
TEST(RowKernel, FindsEverySpanOfSmallTriangles) {
  const std::vector<int32_t> xs_fx8 = {-700, 128, 129, 2000},
                             ys_fx8 = {127, 128, 1000, 1664, 1665, 3100};
  std::vector<selvage_vertex> points;
  for (const int32_t x : xs_fx8) {
    for (const int32_t y : ys_fx8) points.push_back({x, y, 0, 0, 1});
  }
  const std::vector<FindSpans> kernels = row_kernels();
  for (const selvage_vertex& a : points) {
    for (const selvage_vertex& b : points) {
      for (const selvage_vertex& c : points) {
        expect_as_walked_from_any_row({a, b, c}, kernels);
        expect_as_walked_from_any_row({a, b, c, c}, kernels);
        ASSERT_FALSE(HasFailure()) << "(" << a.x << ", " << a.y << "), (" << b.x << ", " << b.y
                                   << "), (" << c.x << ", " << c.y << ")";
      }
    }
  }
}

// Numerators and divisors of full length; most of the lines' rows are another edge's.
TEST(RowKernel, FindsSpansOfTheLargestTriangles) {
  spec::Random random(7);
  constexpr int32_t kEnds_fx8[] = {SELVAGE_X_MIN,     SELVAGE_X_MIN + 1, -1, 0, 1,
                                   SELVAGE_X_END - 2, SELVAGE_X_END - 1};
  for (int i = 0; i < 400; ++i) {
    std::vector<selvage_vertex> vertices(3);
    for (selvage_vertex& v : vertices) {
      v = {random.pick(kEnds_fx8), random.pick(kEnds_fx8), 0, 0, 1};
    }
    Polygon polygon;
    ASSERT_EQ(examine(vertices, &polygon), SELVAGE_OK);
    if (polygon.top_row >= polygon.bottom_row) continue;
    const int32_t top = random.in(polygon.top_row, polygon.bottom_row);
    const selvage_rect visible{-70000, top, 70000, std::min(top + 200, polygon.bottom_row)};
    for (const FindSpans find_spans : row_kernels()) {
      expect_as_walked(polygon, visible, find_spans);
    }
    ASSERT_FALSE(HasFailure());
  }
}

// From the top to the bottom, in whatever order the vertices are given.
TEST(Outline, KnowsTheCornersOfATriangle) {
  const selvage_vertex a{0, 0, 0, 0, 1}, b{900, 500, 0, 0, 1}, c{-300, 800, 0, 0, 1};
  const std::array<std::array<selvage_vertex, 3>, 6> orders = {
      {{a, b, c}, {b, c, a}, {c, a, b}, {a, c, b}, {c, b, a}, {b, a, c}}};
  for (const auto& order : orders) {
    Polygon polygon;
    ASSERT_EQ(examine(order, &polygon), SELVAGE_OK);
    const Outline outline(polygon);
    ASSERT_TRUE(outline.is_triangle());
    const auto& [top, middle, bottom] = outline.corners();
    EXPECT_EQ(top.y, a.y);
    EXPECT_EQ(middle.y, b.y);
    EXPECT_EQ(bottom.y, c.y);
  }
  const selvage_vertex quad[] = {a, b, {500, 900, 0, 0, 1}, c};
  Polygon polygon;
  ASSERT_EQ(examine(quad, &polygon), SELVAGE_OK);
  EXPECT_FALSE(Outline(polygon).is_triangle());
}

}  // namespace
}  // namespace selvage::mapper
