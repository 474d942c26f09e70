// Wrong historic mappers: which pixels are drawn.
#include <algorithm>

#include "coverage/catalogue.h"

namespace selvage::coverage {
namespace {

[[nodiscard]] int32_t highest_px(const Job& job) {
  return std::ranges::min(job.vertices, {}, &selvage_vertex::y).y / SELVAGE_SUBPIXELS;
}

[[nodiscard]] int64_t floor_column(const HistoricEdge& edge, int64_t rows) {
  return edge.left_px() + floor_quotient(rows * edge.width_px(), edge.height_px());
}

// Bresenham's edge after so many rows, each of which adds its fraction to the error term; where
// that has reached `turns_from`, height is taken off it and the column goes one further.
[[nodiscard]] int64_t stepped_column(const HistoricEdge& edge, int64_t rows, int64_t first_error,
                                     int64_t turns_from) {
  const int64_t width = edge.width_px(), height = edge.height_px();
  const int64_t direction = width >= 0 ? 1 : -1;
  const int64_t error = first_error + rows * (width * direction % height);
  const int64_t turns = rows == 0 ? 0 : floor_quotient(error - turns_from, height) + 1;
  return edge.left_px() + rows * (width / height) + direction * std::max<int64_t>(turns, 0);
}

void spoil_error_term(Catalogue* catalogue) {
  catalogue->add({k56}, "error_starts_low", "COV",
                 "the error term of an edge that goes right starts at 1 - height, as of one to the "
                 "left",
                 [](HistoricRecipe& r) {
                   r.column = [](const HistoricEdge& edge, int64_t rows) {
                     return stepped_column(edge, rows, 1 - edge.height_px(), 1);
                   };
                 });
  catalogue->add({k57}, "error_starts_empty", "COV",
                 "the error term of an edge that goes left starts at 0, as of one to the right",
                 [](HistoricRecipe& r) {
                   r.column = [](const HistoricEdge& edge, int64_t rows) {
                     return stepped_column(edge, rows, 0, 1);
                   };
                 });
  catalogue->add({k56, k57}, "error_turns_at_zero", "COV",
                 "the error term turns over when it reaches 0, not when it passes it",
                 [](HistoricRecipe& r) {
                   r.column = [](const HistoricEdge& edge, int64_t rows) {
                     const int64_t first = edge.width_px() >= 0 ? 0 : 1 - edge.height_px();
                     return stepped_column(edge, rows, first, 0);
                   };
                 });
}

void spoil_column(Catalogue* catalogue) {
  catalogue->add({k56, k57}, "left_edges_rounded_down", "SPLIT",
                 "a left edge starts in the column that it runs through", [](HistoricRecipe& r) {
                   r.column = [column = r.column](const HistoricEdge& edge, int64_t rows) {
                     return edge.runs_down ? column(edge, rows) : floor_column(edge, rows);
                   };
                 });
  catalogue->add({kDkit}, "edges_rounded_down", "COV", "edges are rounded down",
                 [](HistoricRecipe& r) { r.column = floor_column; });
  catalogue->add({kDkit}, "edges_rounded_by_truncation", "SHIFT",
                 "edges are rounded by adding a half and cutting the fraction off, so left of 0 "
                 "otherwise",
                 [](HistoricRecipe& r) {
                   r.column = [](const HistoricEdge& edge, int64_t rows) {
                     const int64_t height = edge.height_px();
                     const int64_t x = edge.left_px() * height + rows * edge.width_px();
                     return (2 * x + height) / (2 * height);
                   };
                 });
  catalogue->add({k56, k57, kDkit}, "edge_width_of_16_bits", "COV",
                 "the difference of an edge's columns is kept in 16 bits", [](HistoricRecipe& r) {
                   r.column = [column = r.column](HistoricEdge edge, int64_t rows) {
                     const auto width = static_cast<int16_t>(edge.width_px());
                     edge.bottom.x = edge.top.x + width * SELVAGE_SUBPIXELS;
                     return column(edge, rows);
                   };
                 });
}

void spoil_edge_rows(Catalogue* catalogue) {
  catalogue->add({k56, k57, kDkit}, "lower_edges_a_row_late", "COV",
                 "an edge below a vertex is stepped a row too late", [](HistoricRecipe& r) {
                   r.target_rows = [](const Job& job, const HistoricEdge& edge, int32_t y) {
                     const int64_t rows = int64_t{y} - edge.top_px;
                     return edge.top_px == highest_px(job) ? rows : std::max<int64_t>(rows - 1, 0);
                   };
                 });
  catalogue->add({k56, k57}, "last_row_drawn", "PART", "the polygon's last row is drawn too",
                 [](HistoricRecipe& r) { r.meets = HistoricRecipe(kDkit).meets; });
  catalogue->add({kDkit}, "last_row_left_out", "COV", "the polygon's last row is not drawn",
                 [](HistoricRecipe& r) { r.meets = HistoricRecipe(k56).meets; });
  catalogue->add({k56, k57, kDkit}, "low_edges_skipped", "COV",
                 "an edge of a single row is passed by as if it were flat", [](HistoricRecipe& r) {
                   r.meets = [meets = r.meets](const Job& job, const HistoricEdge& edge,
                                               int32_t y) {
                     return edge.height_px() > 1 && meets(job, edge, y);
                   };
                 });
  catalogue->add({k56, k57, kDkit}, "starts_below_the_first_vertex", "ORDER",
                 "the search for the top vertex passes the first one by", [](HistoricRecipe& r) {
                   r.meets = [meets = r.meets](const Job& job, const HistoricEdge& edge,
                                               int32_t y) {
                     const auto searched = std::span(job.vertices).subspan(1);
                     const auto top = std::ranges::min(searched, {}, &selvage_vertex::y);
                     return y >= top.y / SELVAGE_SUBPIXELS && meets(job, edge, y);
                   };
                 });
}

void spoil_span_coverage(Catalogue* catalogue) {
  catalogue->add({k56, k57}, "last_column_drawn", "PINWHEEL",
                 "the right edge's column is drawn too", [](HistoricRecipe& r) {
                   r.covers = [](const HistoricSpan& span, int32_t x) {
                     return span.left.column_px <= x && x <= span.right.column_px;
                   };
                 });
  catalogue->add({kDkit}, "last_column_left_out", "COV", "the right edge's column is not drawn",
                 [](HistoricRecipe& r) { r.covers = HistoricRecipe(k56).covers; });
  catalogue->add({kDkit}, "one_pixel_left_out", "COV",
                 "a span of one pixel is not drawn, for it has no step", [](HistoricRecipe& r) {
                   r.covers = [covers = r.covers](const HistoricSpan& span, int32_t x) {
                     return span.left.column_px < span.right.column_px && covers(span, x);
                   };
                 });
  catalogue->add({k56, k57}, "draws_both_windings", "ORDER",
                 "polygons that run counter-clockwise are drawn too", [](HistoricRecipe& r) {
                   r.order = [](const EdgePoint& a, const EdgePoint& b) {
                     return b.column_px < a.column_px ? HistoricSpan{b, a} : HistoricSpan{a, b};
                   };
                 });
  catalogue->add(
      {k56}, "left_is_told_by_the_top", "COV",
      "which edge is the left one is told by where their tops lie", [](HistoricRecipe& r) {
        r.order = [](const EdgePoint& a, const EdgePoint& b) {
          return b.edge.left_px() < a.edge.left_px() ? HistoricSpan{b, a} : HistoricSpan{a, b};
        };
      });
}

}  // namespace

void add_wrong_historic_edges(Catalogue* catalogue) {
  spoil_error_term(catalogue);
  spoil_column(catalogue);
  spoil_edge_rows(catalogue);
  spoil_span_coverage(catalogue);
}

}  // namespace selvage::coverage
