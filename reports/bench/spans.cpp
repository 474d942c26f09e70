#include "reports/bench/spans.h"

#include "spec/vertex_units.h"

namespace selvage::reports {

namespace {

using spec::kHalfPixel_fx8;
using spec::kPixel_fx8;

int64_t floor_div(int64_t n, int64_t d) {
  const int64_t q = n / d;
  return q - (n % d < 0 ? 1 : 0);
}

}  // namespace

// Budget: |x|, |y| < 2^23 fx8, so dx, dy < 2^24 and every product below stays under 2^50.
EdgeWalk::EdgeWalk(const selvage_vertex& a, const selvage_vertex& b, int32_t first_row_px,
                   int32_t end_row_px)
    : first_row_px_(first_row_px), end_row_px_(end_row_px) {
  const selvage_vertex& top = a.y < b.y ? a : b;
  const selvage_vertex& bottom = a.y < b.y ? b : a;
  const int64_t dx = int64_t{bottom.x} - top.x;
  const int64_t dy = int64_t{bottom.y} - top.y;
  denominator_ = dy * kPixel_fx8;
  const int64_t centre_fx8 = int64_t{first_row_px} * kPixel_fx8 + kHalfPixel_fx8;
  const int64_t numerator =
      (int64_t{top.x} - kHalfPixel_fx8) * dy + (centre_fx8 - top.y) * dx + denominator_ - 1;
  column_px_ = floor_div(numerator, denominator_);
  rest_ = numerator - column_px_ * denominator_;
  step_px_ = floor_div(dx * kPixel_fx8, denominator_);
  step_rest_ = dx * kPixel_fx8 - step_px_ * denominator_;
}

EdgeList edges_of(std::span<const selvage_vertex> polygon, int32_t height_px) {
  EdgeList list;
  for (size_t i = 0; i < polygon.size(); ++i) {
    const selvage_vertex& a = polygon[i];
    const selvage_vertex& b = polygon[i + 1 == polygon.size() ? 0 : i + 1];
    const int32_t first = std::max(row_at_or_below(std::min(a.y, b.y)), 0);
    const int32_t end = std::min(row_at_or_below(std::max(a.y, b.y)), height_px);
    if (first >= end) continue;
    size_t at = list.count++;
    for (; at > 0 && list.edges[at - 1].first_row_px() > first; --at)
      list.edges[at] = list.edges[at - 1];
    list.edges[at] = EdgeWalk(a, b, first, end);
  }
  return list;
}

uint64_t count_covered(const Workload& load) {
  uint64_t count = 0;
  for (const auto& polygon : load.polygons) {
    for_each_span(polygon, load.target_side_px, load.target_side_px, [&](const Span& span) {
      count += static_cast<uint64_t>(span.right_px - span.left_px);
    });
  }
  return count;
}

}  // namespace selvage::reports
