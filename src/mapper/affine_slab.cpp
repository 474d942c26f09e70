#include "mapper/affine_slab.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace selvage::mapper {

AffineEdge::AffineEdge(const Edge& edge, int32_t first_row) {
  const selvage_vertex &top = edge.top(), &bottom = edge.bottom();
  const int64_t height = int64_t{bottom.y} - top.y;
  const int64_t below_top = centre_fx8(first_row) - int64_t{top.y};
  const auto start = [&](int64_t a, int64_t b) {
    return static_cast<double>(a * height + (b - a) * below_top);
  };
  const auto down = [](int64_t a, int64_t b) { return static_cast<double>((b - a) * kSubpixels); };
  height_ = static_cast<double>(height);
  first_ = {start(top.x, bottom.x), start(top.u, bottom.u), start(top.v, bottom.v)};
  down_ = {down(top.x, bottom.x), down(top.u, bottom.u), down(top.v, bottom.v)};
}
// A mean of two ends times the height, each term twice as large at most.
static_assert(kTexelBits + 2 + kPositionBits < 63 && 2 * kPositionBits + 2 <= 53);

namespace {

[[nodiscard]] int64_t floor_fx32(double estimate_fx32) {
  const double lowered = estimate_fx32 - kRuledSlack_fx32;
  const auto whole = static_cast<int64_t>(lowered);
  return whole - (lowered < static_cast<double>(whole) ? 1 : 0);
}

[[nodiscard]] uint32_t margin_of(const SpanBatch& batch) {
  return kRuledErrorPerPixel_fx32 * static_cast<uint32_t>(batch.widest_px);
}

}  // namespace

// The spec's numbers for q = 1 (8.2). Both weights have the same sign at a pixel, whichever edge is
// on the left, so that nothing cancels (spec/proofs/ruled_rows.g).
void find_ruled_lanes_scalar(const AffineSlab& slab, const SpanBatch& batch, int32_t first_index,
                             int32_t end_index, RuledRows* rows) {
  constexpr double kUnit_fx32 = 1 << (kLaneFraction - kTexelFraction);
  for (int32_t i = first_index; i < end_index; ++i) {
    const auto row = static_cast<size_t>(i);
    const Span span = batch.span(i);
    rows->start[row] = rows->step[row] = {};
    if (span.empty()) continue;
    const int32_t below = span.row - slab.first_row;
    const AffineEdge::Point a = slab.a.at(below), b = slab.b.at(below);
    const double centre = centre_fx8(span.left_px);
    const double weight_a = b.x - centre * slab.b.height(),
                 weight_b = centre * slab.a.height() - a.x;
    const double width = weight_a * slab.a.height() + weight_b * slab.b.height();
    const double denominator = std::abs(width) * (1 << kTexelFraction);
    rows->most_denominator = std::max(rows->most_denominator, denominator);
    const double per_width = kUnit_fx32 / width;
    const auto mean = [&](double of_a, double of_b) {
      return floor_fx32((of_a * weight_a + of_b * weight_b) * per_width);
    };
    rows->start[row] = {mean(a.u, b.u), mean(a.v, b.v)};
    if (span.width_px() == 1) continue;  // only from pixel to pixel is a step below 2^16
    const double per_px = per_width * kSubpixels;
    const auto step = [&](double of_a, double of_b) {
      return floor_fx32((of_b * slab.a.height() - of_a * slab.b.height()) * per_px);
    };
    rows->step[row] = {step(a.u, b.u), step(a.v, b.v)};
  }
}

void find_lanes(std::span<const Slab> slabs, const SpanBatch& batch,
                FindRuledLanes find_ruled_lanes, RuledRows* rows) {
  const int32_t end_row = batch.first_row + batch.rows;
  rows->most_denominator = 0;
  for (const Slab& slab : slabs) {
    const int32_t first = std::max(slab.first_row, batch.first_row);
    const int32_t end = std::min(slab.end_row, end_row);  // before the first one: no row
    find_ruled_lanes(AffineSlab(slab), batch, first - batch.first_row, end - batch.first_row, rows);
  }
  rows->margin_fx32 = margin_of(batch);
}

// A slab costs more than a row. Rows are found in any order, so that no other may be written.
void find_lanes_of(const RuledMap& map, const SpanBatch& batch, std::span<const Span> of,
                   RuledRows* rows) {
  const Slab* last_slab = nullptr;
  std::optional<AffineSlab> lanes;
  int32_t last_row = INT32_MIN;
  rows->most_denominator = 0;
  for (const Span& span : of) {
    if (span.row == last_row) continue;
    last_row = span.row;
    const Slab& slab = map.slab_of(span.row);
    if (&slab != last_slab) lanes.emplace(slab);
    last_slab = &slab;
    const int32_t index = span.row - batch.first_row;
    find_ruled_lanes_scalar(*lanes, batch, index, index + 1, rows);
  }
  rows->margin_fx32 = margin_of(batch);
}

}  // namespace selvage::mapper
