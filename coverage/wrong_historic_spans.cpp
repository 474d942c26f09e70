// Wrong historic mappers: clipping, the ends of spans, texels, and what the call returns.
#include <algorithm>
#include <cstdlib>

#include "coverage/catalogue.h"

namespace selvage::coverage {
namespace {

void spoil_clipping(Catalogue* catalogue) {
  catalogue->add({k56, k57, kDkit}, "left_clip_keeps_source", "CLIP",
                 "pixels that the clip hides on the left do not advance u and v",
                 [](HistoricRecipe& r) {
                   r.walked = [](const Job& job, const HistoricSpan& span, int32_t x) {
                     return x - std::max<int64_t>(span.left.column_px, job.clip.left);
                   };
                 });
  catalogue->add({k56, k57, kDkit}, "left_clip_skips_one_less", "CLIP",
                 "of the pixels that the clip hides on the left one does not advance u and v",
                 [](HistoricRecipe& r) {
                   r.walked = [](const Job& job, const HistoricSpan& span, int32_t x) {
                     const int64_t walked = x - span.left.column_px;
                     return span.left.column_px < job.clip.left ? walked - 1 : walked;
                   };
                 });
  catalogue->add({k56, k57, kDkit}, "top_clip_keeps_source", "CLIP",
                 "rows that the clip hides above do not advance u and v", [](HistoricRecipe& r) {
                   r.source_rows = [](const Job& job, const HistoricEdge& edge, int32_t y) {
                     return int64_t{y} - std::max(edge.top_px, job.clip.top);
                   };
                 });
  catalogue->add({k56, k57, kDkit}, "spans_what_is_visible", "CLIP",
                 "u and v are spread over the columns left of the clip's right side",
                 [](HistoricRecipe& r) {
                   r.steps = [steps = r.steps](const Job& job, const HistoricSpan& span) {
                     return std::min(steps(job, span), job.clip.right - span.left.column_px);
                   };
                 });
  catalogue->add({k56, k57, kDkit}, "clip_inclusive", "MEM",
                 "the clip's last column is inside, as a rectangle's both ends are elsewhere",
                 [](HistoricRecipe& r) {
                   r.in_clip = [](const Job& job, int32_t x, int32_t y) {
                     return job.clip.left <= x && x <= job.clip.right && job.clip.top <= y &&
                            y < job.clip.bottom;
                   };
                 });
}

void spoil_span_ends(Catalogue* catalogue) {
  catalogue->add({kDkit}, "one_column_shows_the_first_edge", "ORDER",
                 "a span of one pixel shows the edge that comes first in the outline",
                 [](HistoricRecipe& r) {
                   r.order = [](const EdgePoint& a, const EdgePoint& b) {
                     return b.column_px < a.column_px ? HistoricSpan{b, a} : HistoricSpan{a, b};
                   };
                 });
  catalogue->add(
      {k56, k57, kDkit}, "left_source_with_right_slope", "MAP",
      "u on the left edge is stepped with the right edge's slope", [](HistoricRecipe& r) {
        r.order = [order = r.order, walk = r.edge_walk](const EdgePoint& a, const EdgePoint& b) {
          HistoricSpan span = order(a, b);
          const HistoricEdge &own = span.left.edge, &other = span.right.edge;
          const int64_t change = int64_t{other.bottom.u} - other.top.u;
          span.left.u_fx16 = walk(own.top.u, own.top.u + change, span.left.rows, other.height_px());
          return span;
        };
      });
  catalogue->add({k56, k57}, "steps_by_visible_edges", "SHIFT",
                 "the span's steps are counted from column 0 where it starts further left",
                 [](HistoricRecipe& r) {
                   r.steps = [](const Job&, const HistoricSpan& span) {
                     const int64_t left = std::max<int64_t>(span.left.column_px, 0);
                     return span.right.column_px - left;
                   };
                 });
  catalogue->add({k56, k57, kDkit}, "planes_repeat_a_column", "SHIFT",
                 "the last of four planes shows what the one before it does",
                 [](HistoricRecipe& r) {
                   r.walked = [](const Job&, const HistoricSpan& span, int32_t x) {
                     const int64_t walked = x - span.left.column_px;
                     return x % 4 == 3 && walked > 0 ? walked - 1 : walked;
                   };
                 });
}

void spoil_texel(Catalogue* catalogue) {
  catalogue->add({k56}, "rounds_texels", "VERT", "texels are rounded where flooring is meant",
                 [](HistoricRecipe& r) { r.texel = HistoricRecipe(k57).texel; });
  catalogue->add({k57, kDkit}, "floors_texels", "MAP", "texels are floored where rounding is meant",
                 [](HistoricRecipe& r) { r.texel = HistoricRecipe(k56).texel; });
  catalogue->add({kDkit}, "halves_rounded_down", "DDA",
                 "a coordinate half way between two texels goes to the lesser one",
                 [](HistoricRecipe& r) {
                   r.texel = [texel = r.texel](int64_t fx16) { return -texel(-fx16); };
                 });
  catalogue->add({k56, k57}, "truncates_texels", "SHIFT", "texels are truncated toward zero",
                 [](HistoricRecipe& r) {
                   const int64_t rounding_fx16 = r.profile == k57 ? SELVAGE_SUBTEXELS / 2 : 0;
                   r.texel = [=](int64_t fx16) {
                     return (fx16 + rounding_fx16) / SELVAGE_SUBTEXELS;
                   };
                 });
  catalogue->add({k56, k57, kDkit}, "reads_past_the_row", "GAMUT",
                 "u at the texture's width is the texel past the row", [](HistoricRecipe& r) {
                   r.address = [address = r.address](int64_t texel, int32_t size,
                                                     selvage_address mode) {
                     return texel == size ? size : address(texel, size, mode);
                   };
                 });
}

void spoil_refusals(Catalogue* catalogue) {
  catalogue->add({k56, k57, kDkit}, "takes_fractions", "TOTAL",
                 "a vertex between pixels is taken without a word", [](HistoricRecipe& r) {
                   r.status = [](selvage_status status) {
                     return status == SELVAGE_ERROR_VERTEX_FRACTION ? SELVAGE_OK : status;
                   };
                 });
  catalogue->add({k56, k57, kDkit}, "takes_perspective", "TOTAL",
                 "q that differ are taken without a word", [](HistoricRecipe& r) {
                   r.status = [](selvage_status status) {
                     return status == SELVAGE_ERROR_VERTEX_Q_DIFFERS ? SELVAGE_OK : status;
                   };
                 });
}

}  // namespace

void add_wrong_historic_spans(Catalogue* catalogue) {
  spoil_clipping(catalogue);
  spoil_span_ends(catalogue);
  spoil_texel(catalogue);
  spoil_refusals(catalogue);
}

}  // namespace selvage::coverage
