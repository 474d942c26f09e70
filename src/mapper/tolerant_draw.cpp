#include "mapper/tolerant_draw.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "mapper/projective_plane.h"
#include "mapper/span_walk.h"

namespace selvage::mapper {
namespace {

// Of a row that is not exact.
[[nodiscard]] int32_t segment_of(const RowChoice& choice, const Span& whole) {
  return choice.method == SELVAGE_METHOD_SUBDIVIDED ? choice.segment_px : whole.width_px();
}

[[nodiscard]] bool is_exact(const RowChoice& choice) {
  return choice.method == SELVAGE_METHOD_EXACT_PERSPECTIVE;
}

// Rows by one map for all: its lanes, and its exact rows together.
class PlaneRows {
 public:
  PlaneRows(const ProjectivePlane& plane, const Polygon& polygon, const selvage_rect& visible,
            FindSpans find_spans, int32_t tolerance_fx16)
      : plane_(plane),
        texels_(polygon.texels),
        visible_(visible),
        walk_(polygon, {polygon.left_px, visible.top, polygon.right_px, visible.bottom},
              find_spans),
        tolerance_fx16_(tolerance_fx16) {}

  // The next rows, clipped by nothing, and their choices; false where none is left.
  [[nodiscard]] bool next() {
    if (!walk_.next(&whole_)) return false;
    for (int32_t i = 0; i < whole_.rows; ++i) {
      const Span span = whole_.span(i);
      choices_[static_cast<size_t>(i)] =
          choose_row(plane_.lanes().of(span), span.width_px(), tolerance_fx16_);
    }
    return true;
  }

  void draw(const Surface& surface, const Kernels& kernels) const {
    SpanBatch exact = whole_, stepped = whole_;
    exact.widest_px = stepped.widest_px = 0;
    std::array<int32_t, kRowsPerBatch> segment_px;
    for (int32_t i = 0; i < whole_.rows; ++i) {
      const auto row = static_cast<size_t>(i);
      const Span span = visible_part(i);
      SpanBatch &part = is_exact(choice(i)) ? exact : stepped,
                &other = is_exact(choice(i)) ? stepped : exact;
      part.left_px[row] = other.left_px[row] = other.right_px[row] = span.left_px;
      part.right_px[row] = span.right_px;
      part.widest_px = std::max(part.widest_px, span.width_px());
      segment_px[row] = segment_of(choice(i), whole_.span(i));
    }
    if (stepped.widest_px != 0) {
      kernels.draw_stepped({stepped, whole_, plane_.lanes(), segment_px.data()}, surface);
    }
    if (exact.widest_px == 0) return;
    kernels.draw_projective({exact, plane_.lanes(), texels_, ExactMap(plane_)}, surface);
  }

  // Calls visit(choice) for each visible row.
  template <class Visit>
  void for_each_choice(const Visit& visit) const {
    for (int32_t i = 0; i < whole_.rows; ++i) {
      if (!visible_part(i).empty()) visit(choice(i));
    }
  }

 private:
  [[nodiscard]] const RowChoice& choice(int32_t i) const {
    return choices_[static_cast<size_t>(i)];
  }
  [[nodiscard]] Span visible_part(int32_t i) const {
    const Span whole = whole_.span(i);
    const int32_t left_px = std::clamp(whole.left_px, visible_.left, visible_.right);
    return {whole.row, left_px, std::max(left_px, std::min(whole.right_px, visible_.right))};
  }

  const ProjectivePlane& plane_;
  const TexelBox& texels_;
  selvage_rect visible_;
  BatchWalk walk_;
  int32_t tolerance_fx16_;
  SpanBatch whole_;
  std::array<RowChoice, kRowsPerBatch> choices_;
};

// A row by the map between its own two edges.
struct RuledRow {
  SpanMap map;
  Span whole;
  ProjectiveLanes lanes;
  RowChoice choice;

  RuledRow(const SpanWalk& walk, int32_t tolerance_fx16)
      : map(walk.map()),
        whole(walk.whole_span()),
        lanes(map, whole),
        choice(choose_row(lanes, whole.width_px(), tolerance_fx16)) {}
};

void draw_row(const RuledRow& row, const Span& span, const TexelBox& texels, const Surface& surface,
              const Kernels& kernels) {
  if (!is_exact(row.choice)) {
    const int32_t segment_px = segment_of(row.choice, row.whole);
    return kernels.draw_stepped(
        {one_span(span), one_span(row.whole), row.lanes.field(row.whole), &segment_px}, surface);
  }
  const bool clipped = span.width_px() != row.whole.width_px();
  const ProjectiveLanes lanes = clipped ? ProjectiveLanes(row.map, span) : row.lanes;
  const SpanBatch batch = one_span(span);
  kernels.draw_projective({batch, lanes.field(span), texels, ExactMap(row.map)}, surface);
}

[[nodiscard]] std::optional<ProjectivePlane> plane_of(const Polygon& polygon) {
  std::optional<ProjectivePlane> plane = ProjectivePlane::of_all(polygon);
  if (plane && plane->lanes().error_fx32 > kMostSteppedError_fx32) plane.reset();
  return plane;
}

}  // namespace

void draw_tolerantly(const Surface& surface, const selvage_rect& visible, const Polygon& polygon,
                     const Kernels& kernels, int32_t tolerance_fx16) {
  if (const auto plane = plane_of(polygon)) {
    PlaneRows rows(*plane, polygon, visible, kernels.find_spans, tolerance_fx16);
    while (rows.next()) rows.draw(surface, kernels);
    return;
  }
  SpanWalk walk(polygon, visible);
  while (walk.next())
    draw_row({walk, tolerance_fx16}, walk.span(), polygon.texels, surface, kernels);
}

RowChoice choose_tolerantly(const selvage_rect& visible, const Polygon& polygon,
                            int32_t tolerance_fx16) {
  RowChoice all{SELVAGE_METHOD_NONE, 0, 0};
  const auto add = [&](const RowChoice& row) {
    const bool shorter = all.segment_px == 0 || row.segment_px < all.segment_px;
    if (row.segment_px != 0 && shorter) all.segment_px = row.segment_px;
    all.method = std::max(all.method, row.method);
    all.bound_fx16 = std::max(all.bound_fx16, row.bound_fx16);
  };
  if (const auto plane = plane_of(polygon)) {
    PlaneRows rows(*plane, polygon, visible, find_spans_scalar, tolerance_fx16);
    while (rows.next()) rows.for_each_choice(add);
    return all;
  }
  SpanWalk walk(polygon, visible);
  while (walk.next()) add(RuledRow(walk, tolerance_fx16).choice);
  return all;
}

}  // namespace selvage::mapper
