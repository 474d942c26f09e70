#include "mapper/tolerant_draw.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "mapper/perspective_draw.h"
#include "mapper/projective_plane.h"
#include "mapper/span_walk.h"

namespace selvage::mapper {
namespace {

// Rows by one map for all: its lanes, and its exact rows together.
class PlaneRows {
 public:
  PlaneRows(const ProjectivePlane& plane, const PlaneBend& bend, const Polygon& polygon,
            const selvage_rect& part, FindSpans find_spans, int32_t tolerance_fx16,
            const Stepping& stepping)
      : plane_(plane),
        bend_(bend),
        texels_(polygon.texels),
        part_(part),
        walk_(polygon, {polygon.left_px, part.top, polygon.right_px, part.bottom}, find_spans),
        margin_fx32_(2 * plane.lanes().error_fx32),
        tolerance_fx16_(tolerance_fx16),
        stepping_(stepping) {}

  // The next rows, clipped by nothing; false where none is left.
  [[nodiscard]] bool next() { return walk_.next(&whole_); }

  void draw(const Surface& surface, const Kernels& kernels) const {
    SpanBatch exact, stepped;
    exact.first_row = stepped.first_row = whole_.first_row;
    exact.rows = stepped.rows = whole_.rows;
    exact.widest_px = stepped.widest_px = 0;
    std::array<int32_t, kRowsPerBatch> segment_px;
    for (int32_t i = 0; i < whole_.rows; ++i) {
      const auto row = static_cast<size_t>(i);
      const Span span = visible_part(i);
      segment_px[row] = choose(i);
      const bool is_exact = segment_px[row] == 0;
      exact.left_px[row] = stepped.left_px[row] = span.left_px;
      exact.right_px[row] = is_exact ? span.right_px : span.left_px;
      stepped.right_px[row] = is_exact ? span.left_px : span.right_px;
      exact.widest_px = std::max(exact.widest_px, is_exact ? span.width_px() : 0);
      stepped.widest_px = std::max(stepped.widest_px, is_exact ? 0 : span.width_px());
    }
    if (stepped.widest_px != 0) {
      kernels.draw_stepped({stepped, whole_, plane_.lanes(), segment_px.data()}, surface);
    }
    if (exact.widest_px != 0) {
      kernels.draw_projective({exact, plane_.lanes(), texels_, ExactMap(plane_)}, surface);
    }
  }

  // Calls visit(choice) for each visible row.
  template <class Visit>
  void for_each_choice(const Visit& visit) const {
    for (int32_t i = 0; i < whole_.rows; ++i) {
      if (visible_part(i).empty()) continue;
      const Span row = whole_.span(i);
      visit(choose_row(bend_.of(row), margin_fx32_, row.width_px(), tolerance_fx16_, stepping_));
    }
  }

 private:
  [[nodiscard]] Span visible_part(int32_t i) const {
    const Span whole = whole_.span(i);
    const int32_t left_px = std::clamp(whole.left_px, part_.left, part_.right);
    return {whole.row, left_px, std::max(left_px, std::min(whole.right_px, part_.right))};
  }
  [[nodiscard]] int32_t choose(int32_t i) const {
    const Span row = whole_.span(i);
    return choose_segment_px(bend_.of(row), margin_fx32_, row.width_px(), tolerance_fx16_,
                             stepping_);
  }

  const ProjectivePlane& plane_;
  const PlaneBend& bend_;
  const TexelBox& texels_;
  selvage_rect part_;
  BatchWalk walk_;
  int64_t margin_fx32_;
  int32_t tolerance_fx16_;
  Stepping stepping_;
  SpanBatch whole_;
};

// A row by the map between its own two edges.
struct RuledRow {
  SpanMap map;
  Span whole;
  ProjectiveLanes lanes;

  explicit RuledRow(const SpanWalk& walk)
      : map(walk.map()), whole(walk.whole_span()), lanes(map, whole) {}

  [[nodiscard]] RowBend bend() const { return bend_of(lanes, whole.width_px()); }
};

void draw_row(const RuledRow& row, const Span& span, const TexelBox& texels, const Surface& surface,
              const Kernels& kernels, int32_t tolerance_fx16) {
  const int32_t width_px = row.whole.width_px();
  const int32_t segment_px = choose_segment_px(row.bend(), row.lanes.margin_fx32(), width_px,
                                               tolerance_fx16, kernels.stepping);
  if (segment_px != 0) {
    return kernels.draw_stepped(
        {one_span(span), one_span(row.whole), row.lanes.field(row.whole), &segment_px}, surface);
  }
  if (span.width_px() == width_px) {
    return draw_in_perspective(row.map, span, row.lanes, texels, surface, kernels);
  }
  draw_in_perspective(row.map, span, ProjectiveLanes(row.map, span), texels, surface, kernels);
}

[[nodiscard]] std::optional<ProjectivePlane> plane_of(const Polygon& polygon) {
  std::optional<ProjectivePlane> plane = ProjectivePlane::of_all(polygon);
  if (plane && plane->lanes().error_fx32 > kMostSteppedError_fx32) plane.reset();
  return plane;
}

[[nodiscard]] PlaneBend bend_of(const ProjectivePlane& plane, const Polygon& polygon) {
  return {plane.lanes(), polygon.bottom_row - polygon.top_row};
}

// Whether some row may be stepped.
[[nodiscard]] bool may_step(const PlaneBend& bend, const Polygon& polygon, int32_t tolerance_fx16,
                            const Stepping& stepping) {
  const auto [near, far] = std::ranges::minmax(polygon.vertices, {}, &selvage_vertex::q);
  // In units of the least one, as the plane's are. Roundings are far below the units of a tolerance
  // that are kept for those of lanes.
  const double most_denominator = static_cast<double>(far.q) / near.q;
  return !bends_too_much(bend.least(most_denominator), tolerance_fx16, stepping);
}

}  // namespace

void draw_tolerantly(const Surface& surface, const selvage_rect& part, const Polygon& polygon,
                     const Kernels& kernels, int32_t tolerance_fx16) {
  if (const auto plane = plane_of(polygon)) {
    const PlaneBend bend = bend_of(*plane, polygon);
    if (!may_step(bend, polygon, tolerance_fx16, kernels.stepping)) {
      return draw_in_perspective(*plane, polygon, part, surface, kernels);
    }
    PlaneRows rows(*plane, bend, polygon, part, kernels.find_spans, tolerance_fx16,
                   kernels.stepping);
    while (rows.next()) rows.draw(surface, kernels);
    return;
  }
  SpanWalk walk(polygon, part);
  while (walk.next()) {
    draw_row(RuledRow(walk), walk.span(), polygon.texels, surface, kernels, tolerance_fx16);
  }
}

RowChoice choose_tolerantly(const selvage_rect& part, const Polygon& polygon,
                            int32_t tolerance_fx16, const Stepping& stepping) {
  RowChoice all{SELVAGE_METHOD_NONE, 0, 0};
  const auto add = [&](const RowChoice& row) {
    const bool shorter = all.segment_px == 0 || row.segment_px < all.segment_px;
    if (row.segment_px != 0 && shorter) all.segment_px = row.segment_px;
    all.method = std::max(all.method, row.method);
    all.bound_fx16 = std::max(all.bound_fx16, row.bound_fx16);
  };
  if (const auto plane = plane_of(polygon)) {
    const PlaneBend bend = bend_of(*plane, polygon);
    if (!may_step(bend, polygon, tolerance_fx16, stepping))
      return {SELVAGE_METHOD_EXACT_PERSPECTIVE, 0, 0};
    PlaneRows rows(*plane, bend, polygon, part, find_spans_scalar, tolerance_fx16, stepping);
    while (rows.next()) rows.for_each_choice(add);
    return all;
  }
  SpanWalk walk(polygon, part);
  while (walk.next()) {
    const RuledRow row(walk);
    add(choose_row(row.bend(), row.lanes.margin_fx32(), row.whole.width_px(), tolerance_fx16,
                   stepping));
  }
  return all;
}

}  // namespace selvage::mapper
