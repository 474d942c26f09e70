// Rows in perspective, each as cheap as a tolerance allows: those of a plane, and those of a slab
// in none.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "mapper/bend.h"
#include "mapper/kernel.h"
#include "mapper/perspective_draw.h"
#include "mapper/projective_plane.h"
#include "mapper/projective_slab.h"
#include "mapper/slab.h"
#include "mapper/span_batch.h"
#include "mapper/tolerance.h"

namespace selvage::mapper {

// Whole rows and what is visible of them, in a batch of which some are drawn exactly and some not.
class RowParts {
 public:
  RowParts(const Polygon& polygon, const selvage_rect& part, FindSpans find_spans)
      : part_(part),
        walk_(polygon, {polygon.left_px, part.top, polygon.right_px, part.bottom}, find_spans) {}

  // The next rows, clipped by nothing; false where none is left.
  [[nodiscard]] bool next() { return walk_.next(&whole_); }
  [[nodiscard]] const SpanBatch& whole() const { return whole_; }
  [[nodiscard]] Span visible(int32_t i) const {
    const Span whole = whole_.span(i);
    const int32_t left_px = std::clamp(whole.left_px, part_.left, part_.right);
    return {whole.row, left_px, std::max(left_px, std::min(whole.right_px, part_.right))};
  }

 private:
  selvage_rect part_;
  BatchWalk walk_;
  SpanBatch whole_;
};

// Some rows of a batch; the others are empty.
class SomeRows {
 public:
  explicit SomeRows(const SpanBatch& of) {
    rows_.first_row = of.first_row;
    rows_.rows = of.rows;
    rows_.widest_px = 0;
  }
  void put(int32_t i, const Span& span, bool has) {
    const auto row = static_cast<size_t>(i);
    rows_.left_px[row] = span.left_px;
    rows_.right_px[row] = has ? span.right_px : span.left_px;
    rows_.widest_px = std::max(rows_.widest_px, has ? span.width_px() : 0);
  }
  [[nodiscard]] bool any() const { return rows_.widest_px != 0; }
  [[nodiscard]] const SpanBatch& get() const { return rows_; }

 private:
  SpanBatch rows_;
};

// What a row may be off by, and what may be stepped.
struct Tolerance {
  int32_t fx16;
  Stepping stepping;
};

// Rows by one map for all: its lanes, and its exact rows together.
class PlaneRows {
 public:
  PlaneRows(const ProjectivePlane& plane, const PlaneBend& bend, const Polygon& polygon,
            const selvage_rect& part, FindSpans find_spans, const Tolerance& tolerance)
      : plane_(plane),
        bend_(bend),
        texels_(polygon.texels),
        rows_(polygon, part, find_spans),
        margin_fx32_(2 * plane.lanes().error_fx32),
        tolerance_(tolerance) {}

  [[nodiscard]] bool next() { return rows_.next(); }

  void draw(const Surface& surface, const Kernels& kernels) const {
    const SpanBatch& whole = rows_.whole();
    SomeRows exact(whole), stepped(whole);
    std::array<int32_t, kRowsPerBatch> segment_px;
    for (int32_t i = 0; i < whole.rows; ++i) {
      const Span row = whole.span(i), span = rows_.visible(i);
      const int32_t length_px = choose_segment_px(bend_.of(row), margin_fx32_, row.width_px(),
                                                  tolerance_.fx16, tolerance_.stepping);
      segment_px[static_cast<size_t>(i)] = length_px;
      exact.put(i, span, length_px == 0);
      stepped.put(i, span, length_px != 0);
    }
    if (stepped.any()) {
      kernels.draw_stepped({stepped.get(), whole, plane_.lanes(), segment_px.data()}, surface);
    }
    if (exact.any()) {
      kernels.draw_projective({exact.get(), plane_.lanes(), texels_, ExactMap(plane_)}, surface);
    }
  }

  // Calls visit(choice) for each visible row.
  template <class Visit>
  void for_each_choice(const Visit& visit) const {
    for (int32_t i = 0; i < rows_.whole().rows; ++i) {
      if (rows_.visible(i).empty()) continue;
      const Span row = rows_.whole().span(i);
      visit(choose_row(bend_.of(row), margin_fx32_, row.width_px(), tolerance_.fx16,
                       tolerance_.stepping));
    }
  }

 private:
  const ProjectivePlane& plane_;
  const PlaneBend& bend_;
  const TexelBox& texels_;
  RowParts rows_;
  int64_t margin_fx32_;
  Tolerance tolerance_;
};

// Rows of a slab in no plane, each by the map between its own two edges: exact ones by the slab's
// formula, if it has one.
class SlabRows {
 public:
  SlabRows(const Slab& slab, const Polygon& outline, const selvage_rect& part, FindSpans find_spans,
           const Tolerance& tolerance)
      : map_(slab),
        field_(ruled_field(slab, outline,
                           {outline.left_px, slab.first_row, outline.right_px, slab.end_row})),
        texels_(outline.texels),
        rows_(outline, part, find_spans),
        tolerance_(tolerance) {}

  [[nodiscard]] bool next() { return rows_.next(); }

  void draw(const Surface& surface, const Kernels& kernels) const {
    const SpanBatch& whole = rows_.whole();
    SomeRows exact(whole);
    for (int32_t i = 0; i < whole.rows; ++i) {
      const Span span = rows_.visible(i);
      const bool is_exact = !draw_stepped(whole.span(i), span, surface, kernels);
      exact.put(i, span, is_exact && field_);
      if (is_exact && !field_) draw_exactly(span, surface, kernels);
    }
    if (exact.any()) {
      kernels.draw_projective({exact.get(), *field_, texels_, ExactMap(map_)}, surface);
    }
  }

  template <class Visit>
  void for_each_choice(const Visit& visit) const {
    for (int32_t i = 0; i < rows_.whole().rows; ++i) {
      if (rows_.visible(i).empty()) continue;
      const Span row = rows_.whole().span(i);
      if (is_surely_exact(row)) {
        visit(RowChoice{SELVAGE_METHOD_EXACT_PERSPECTIVE, 0, 0});
        continue;
      }
      const ProjectiveLanes lanes(map_.at(row.row), row);
      visit(choose_row(bend_of(lanes, row.width_px()), lanes.margin_fx32(), row.width_px(),
                       tolerance_.fx16, tolerance_.stepping));
    }
  }

 private:
  // By the formula, and so roughly, which may leave a row exact that need not be; it costs far less
  // than the row's own lanes.
  [[nodiscard]] bool is_surely_exact(const Span& row) const {
    if (row.width_px() < tolerance_.stepping.least_row_px) return true;
    const int32_t twice_fx16 = std::min(tolerance_.fx16, INT32_MAX / 2) * 2;
    return field_ && bends_too_much(bend_of(field_->of(row), row.width_px()), twice_fx16,
                                    tolerance_.stepping);
  }

  void draw_exactly(const Span& span, const Surface& surface, const Kernels& kernels) const {
    if (span.empty()) return;
    const SpanMap map = map_.at(span.row);
    draw_in_perspective(map, span, ProjectiveLanes(map, span), texels_, surface, kernels);
  }

  // False, and nothing is drawn, where the row is exact.
  [[nodiscard]] bool draw_stepped(const Span& row, const Span& span, const Surface& surface,
                                  const Kernels& kernels) const {
    if (is_surely_exact(row)) return false;
    const ProjectiveLanes lanes(map_.at(row.row), row);
    const int32_t segment_px =
        choose_segment_px(bend_of(lanes, row.width_px()), lanes.margin_fx32(), row.width_px(),
                          tolerance_.fx16, tolerance_.stepping);
    if (segment_px == 0) return false;
    kernels.draw_stepped({one_span(span), one_span(row), lanes.field(row), &segment_px}, surface);
    return true;
  }

  RuledMap map_;
  std::optional<ProjectiveField> field_;
  const TexelBox& texels_;
  RowParts rows_;
  Tolerance tolerance_;
};

}  // namespace selvage::mapper
