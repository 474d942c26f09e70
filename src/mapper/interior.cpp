#include "mapper/interior.h"

#include <algorithm>

namespace selvage::mapper {

namespace {

// Of lanes and what they may lack.
class Inside {
 public:
  explicit Inside(const selvage_texture& texture)
      : end_u_fx32_(end_fx32(texture.width)), end_v_fx32_(end_fx32(texture.height)) {}

  [[nodiscard]] bool has(const Lane& lane, uint32_t margin_fx32) const {
    return static_cast<uint64_t>(lane.u_fx32) < end_u_fx32_ - margin_fx32 &&
           static_cast<uint64_t>(lane.v_fx32) < end_v_fx32_ - margin_fx32;
  }

 private:
  // Unsigned, so that what is below 0 is too much as well.
  [[nodiscard]] static uint64_t end_fx32(int32_t size_texel) {
    return uint64_t{static_cast<uint32_t>(size_texel)} << kLaneFraction;
  }

  uint64_t end_u_fx32_, end_v_fx32_;
};

}  // namespace

bool pays_to_ask_inside(const SpanBatch& batch) {
  constexpr int32_t kLeast_px = 64;
  return batch.widest_px >= kLeast_px;
}

// u and v are monotone along a span: its ends have the least and the most.
bool is_inside(const SpanBatch& batch, const AffineField& field, const selvage_texture& texture) {
  const Inside inside(texture);
  for (int32_t i = 0; i < batch.rows; ++i) {
    const Span span = batch.span(i);
    if (!span.empty() && !(inside.has(field.at(span.left_px, span.row), field.margin_fx32) &&
                           inside.has(field.at(span.right_px - 1, span.row), field.margin_fx32))) {
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
