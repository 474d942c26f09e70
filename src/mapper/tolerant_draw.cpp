#include "mapper/tolerant_draw.h"

#include <algorithm>
#include <cstdint>

#include "mapper/span_walk.h"

namespace selvage::mapper {
namespace {

// A row, clipped or not: its lanes and what it is drawn by.
struct TolerantRow {
  SpanMap map;
  Span whole;
  ProjectiveLanes lanes;
  RowChoice choice;

  TolerantRow(const SpanWalk& walk, int32_t tolerance_fx16)
      : map(walk.map()),
        whole(walk.whole_span()),
        lanes(map, whole),
        choice(choose_row(lanes, whole.width_px(), tolerance_fx16)) {}
};

[[nodiscard]] int32_t in_whole_groups_px(int32_t width_px) {
  return (width_px + kStepGroup_px - 1) / kStepGroup_px * kStepGroup_px;
}

void draw_row(const TolerantRow& row, const Span& span, const Surface& surface,
              const Kernels& kernels) {
  if (row.choice.method == SELVAGE_METHOD_EXACT_PERSPECTIVE) {
    const bool clipped = span.width_px() != row.whole.width_px();
    const ProjectiveLanes lanes = clipped ? ProjectiveLanes(row.map, span) : row.lanes;
    const SpanBatch batch = one_span(span);
    kernels.draw_projective({batch, lanes.field(span), ExactMap(row.map)}, surface);
    return;
  }
  const int32_t segment_px = row.choice.method == SELVAGE_METHOD_SUBDIVIDED
                                 ? row.choice.segment_px
                                 : in_whole_groups_px(row.whole.width_px());
  kernels.draw_stepped({span, row.whole, row.lanes, segment_px}, surface);
}

}  // namespace

void draw_tolerantly(const Surface& surface, const selvage_rect& visible, const Polygon& polygon,
                     const Kernels& kernels, int32_t tolerance_fx16) {
  SpanWalk walk(polygon, visible);
  while (walk.next()) draw_row({walk, tolerance_fx16}, walk.span(), surface, kernels);
}

RowChoice choose_tolerantly(const selvage_rect& visible, const Polygon& polygon,
                            int32_t tolerance_fx16) {
  RowChoice all{SELVAGE_METHOD_NONE, 0, 0};
  SpanWalk walk(polygon, visible);
  while (walk.next()) {
    const RowChoice row = TolerantRow(walk, tolerance_fx16).choice;
    const bool shorter = all.segment_px == 0 || row.segment_px < all.segment_px;
    if (row.segment_px != 0 && shorter) all.segment_px = row.segment_px;
    all.method = std::max(all.method, row.method);
    all.bound_fx16 = std::max(all.bound_fx16, row.bound_fx16);
  }
  return all;
}

}  // namespace selvage::mapper
