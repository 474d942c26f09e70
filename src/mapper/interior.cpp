#include "mapper/interior.h"

#include <algorithm>

namespace selvage::mapper {

// u and v are monotone along a span: its ends have the least and the most.
bool is_inside(const SpanBatch& batch, const AffineField& field, const selvage_texture& texture) {
  // Unsigned, so that what is below 0 is too much as well.
  const uint64_t end_u = (uint64_t{1} << kLaneFraction) * static_cast<uint32_t>(texture.width);
  const uint64_t end_v = (uint64_t{1} << kLaneFraction) * static_cast<uint32_t>(texture.height);
  const auto shows_inside = [&](const Lane& lane) {
    return static_cast<uint64_t>(lane.u_fx32) < end_u - field.margin_fx32 &&
           static_cast<uint64_t>(lane.v_fx32) < end_v - field.margin_fx32;
  };
  for (int32_t i = 0; i < batch.rows; ++i) {
    const Span span = batch.span(i);
    if (!span.empty() && !(shows_inside(field.at(span.left_px, span.row)) &&
                           shows_inside(field.at(span.right_px - 1, span.row)))) {
      return false;
    }
  }
  return true;
}

InteriorOfLine::InteriorOfLine(int64_t step_fx32, int32_t size_texel, uint32_t margin_fx32)
    : end_fx32_((int64_t{size_texel - 1} << kLaneFraction) - margin_fx32),
      columns_per_fx32_(step_fx32 == 0 ? kSteep : 1.0 / static_cast<double>(step_fx32)) {}

// Two quotients round to less than a column of what they are, where they are columns of a row at
// all: kSlack makes up for it.
void InteriorOfLine::narrow(int64_t lane_fx32, Columns* columns) const {
  const double at_zero = static_cast<double>(-lane_fx32) * columns_per_fx32_;
  const double at_end = static_cast<double>(end_fx32_ - lane_fx32) * columns_per_fx32_;
  columns->first = std::max(columns->first, std::min(at_zero, at_end) + kSlack);
  columns->end = std::min(columns->end, std::max(at_zero, at_end) - kSlack);
}

Interior::Interior(const AffineField& field, const selvage_texture& texture)
    : field_(field),
      has_pairs_(texture.layout == SELVAGE_LAYOUT_ROWS && texture.width > 1 && texture.height > 1),
      u_(field.step_x.u_fx32, texture.width, field.margin_fx32),
      v_(field.step_x.v_fx32, texture.height, field.margin_fx32) {}

Span Interior::of(const Span& span) const {
  if (!has_pairs_) return {span.row, span.left_px, span.left_px};
  constexpr int64_t kHalf_fx32 = int64_t{1} << (kLaneFraction - 1);
  const Lane lane = field_.at(span.left_px, span.row);
  Columns columns{0, static_cast<double>(span.width_px())};
  u_.narrow(lane.u_fx32 - kHalf_fx32, &columns);
  v_.narrow(lane.v_fx32 - kHalf_fx32, &columns);
  if (!(columns.first < columns.end)) return {span.row, span.left_px, span.left_px};
  const bool from_start = columns.first == 0;
  const auto first = static_cast<int32_t>(columns.first) + (from_start ? 0 : 1);
  const auto end = static_cast<int32_t>(columns.end);
  return {span.row, span.left_px + first, span.left_px + std::max(first, end)};
}

}  // namespace selvage::mapper
