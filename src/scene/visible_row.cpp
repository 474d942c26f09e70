#include "scene/visible_row.h"

#include <algorithm>
#include <utility>

namespace selvage::scene {

std::span<const Segment> VisibleRow::resolve(std::span<const RowSpan> spans) {
  row_.clear();
  for (size_t i = 0; i < spans.size(); ++i) add(spans, i);
  return row_;
}

void VisibleRow::add(std::span<const RowSpan> spans, size_t newcomer) {
  const RowSpan& span = spans[newcomer];
  next_.clear();
  int32_t free_px = span.first_px();  // from here on nothing of the newcomer is placed
  for (const Segment& old : row_) {
    const int32_t gap_end_px = std::min(old.first_px, span.end_px());
    if (free_px < gap_end_px) {
      put(free_px, gap_end_px, newcomer);
      free_px = gap_end_px;
    }
    const Segment overlap{std::max(old.first_px, span.first_px()),
                          std::min(old.end_px, span.end_px()), old.span};
    if (overlap.first_px >= overlap.end_px) {
      put(old.first_px, old.end_px, old.span);
      continue;
    }
    put(old.first_px, overlap.first_px, old.span);
    contest(spans, overlap, newcomer);
    put(overlap.end_px, old.end_px, old.span);
    free_px = overlap.end_px;
  }
  put(free_px, span.end_px(), newcomer);
  std::swap(row_, next_);
}

void VisibleRow::contest(std::span<const RowSpan> spans, const Segment& overlap, size_t newcomer) {
  const auto wins = [&](int32_t x_px) { return spans[newcomer].hides(spans[overlap.span], x_px); };
  const bool wins_first = wins(overlap.first_px), wins_last = wins(overlap.end_px - 1);
  int32_t same_px = overlap.first_px, other_px = overlap.end_px - 1;  // as at the left end, or not
  if (wins_first == wins_last) same_px = other_px++;
  while (other_px - same_px > 1) {
    const int32_t middle_px = same_px + (other_px - same_px) / 2;
    (wins(middle_px) == wins_first ? same_px : other_px) = middle_px;
  }
  put(overlap.first_px, other_px, wins_first ? newcomer : overlap.span);
  put(other_px, overlap.end_px, wins_first ? overlap.span : newcomer);
}

void VisibleRow::put(int32_t first_px, int32_t end_px, size_t span) {
  if (first_px >= end_px) return;
  if (!next_.empty() && next_.back().span == span && next_.back().end_px == first_px) {
    next_.back().end_px = end_px;
  } else {
    next_.push_back({first_px, end_px, span});
  }
}

}  // namespace selvage::scene
