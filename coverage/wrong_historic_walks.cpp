// Wrong historic mappers: the arithmetic of the source's coordinates, on edges and along spans.
#include <utility>

#include "coverage/catalogue.h"
#include "spec/vertex_units.h"

namespace selvage::coverage {
namespace {

using spec::kTexel_fx16;

using Divide = int64_t (*)(int64_t a, int64_t b);

[[nodiscard]] int64_t rounded_quotient(int64_t a, int64_t b) {
  return floor_quotient(2 * a + b, 2 * b);
}

// The profile's walk with another division.
[[nodiscard]] Walk divided_by(selvage_profile profile, Divide divide) {
  return [=](int64_t a, int64_t b, int64_t walked, int64_t steps) {
    const int64_t step = divide(b - a, steps);
    return a + walked * step + (profile == k57 ? floor_quotient(step, 2) : 0);
  };
}

void divide_by(HistoricRecipe& r, Divide divide) {
  r.edge_walk = r.span_walk = divided_by(r.profile, divide);
}

void spoil_division(Catalogue* catalogue) {
  catalogue->add({k56, k57}, "division_rounded", "DDA", "steps are rounded, not truncated",
                 [](HistoricRecipe& r) { divide_by(r, rounded_quotient); });
  catalogue->add({k56, k57}, "division_floored", "DDA", "falling steps are rounded down",
                 [](HistoricRecipe& r) { divide_by(r, floor_quotient); });
  catalogue->add({k56, k57}, "division_by_reciprocal", "DDA",
                 "steps are multiplied by a reciprocal of 16 bits of fraction",
                 [](HistoricRecipe& r) {
                   divide_by(r, [](int64_t a, int64_t b) {
                     return floor_quotient(a * (kTexel_fx16 / b), kTexel_fx16);
                   });
                 });
  catalogue->add({k56, k57}, "operands_divided_apart", "DDA",
                 "both ends are divided before they are subtracted", [](HistoricRecipe& r) {
                   r.span_walk = [profile = r.profile](int64_t a, int64_t b, int64_t walked,
                                                       int64_t steps) {
                     const int64_t step = b / steps - a / steps;
                     return a + walked * step + (profile == k57 ? floor_quotient(step, 2) : 0);
                   };
                 });
  catalogue->add(
      {k56, k57, kDkit}, "difference_of_32_bits", "MAP",
      "the difference of an edge's coordinates overflows 32 bits", [](HistoricRecipe& r) {
        r.edge_walk = [walk = r.edge_walk](int64_t a, int64_t b, int64_t walked, int64_t steps) {
          return walk(a, a + static_cast<int32_t>(b - a), walked, steps);
        };
      });
}

void spoil_width(Catalogue* catalogue) {
  catalogue->add({k56, k57}, "span_over_one_less", "MAP",
                 "the span is divided by its last column's distance, its width less 1",
                 [](HistoricRecipe& r) {
                   r.steps = [](const Job&, const HistoricSpan& span) {
                     return span.right.column_px - span.left.column_px - 1;
                   };
                 });
  catalogue->add({k56, kDkit}, "span_over_one_more", "IDENTITY",
                 "the span is divided by one column more than it has", [](HistoricRecipe& r) {
                   r.steps = [steps = r.steps](const Job& job, const HistoricSpan& span) {
                     return steps(job, span) + 1;
                   };
                 });
}

void spoil_half_steps(Catalogue* catalogue) {
  catalogue->add({k57}, "no_prestep_on_edges", "MAP", "edges start at their vertex",
                 [](HistoricRecipe& r) { r.edge_walk = truncated_walk; });
  catalogue->add({k57}, "no_prestep_on_spans", "MAP", "spans start at their edge",
                 [](HistoricRecipe& r) { r.span_walk = truncated_walk; });
  catalogue->add(
      {k57}, "half_step_toward_zero", "DDA",
      "half a step is taken by division, which rounds a falling one up", [](HistoricRecipe& r) {
        r.edge_walk = r.span_walk = [](int64_t a, int64_t b, int64_t walked, int64_t steps) {
          return truncated_walk(a, b, walked, steps) + (b - a) / steps / 2;
        };
      });
  catalogue->add({k57}, "half_step_divided_anew", "DDA",
                 "half a step is the difference over twice the steps, not half the step",
                 [](HistoricRecipe& r) {
                   r.edge_walk =
                       r.span_walk = [](int64_t a, int64_t b, int64_t walked, int64_t steps) {
                         return truncated_walk(a, b, walked, steps) + (b - a) / (2 * steps);
                       };
                 });
  catalogue->add(
      {k57}, "untransformed_not_copied", "IDENTITY",
      "as many texel centres as pixels are stepped like all others",
      [](HistoricRecipe& r) { r.block_shift = [](const Job&) { return std::nullopt; }; });
}

void spoil_precision(Catalogue* catalogue) {
  catalogue->add({k56, k57}, "source_of_8_8", "MAP", "u and v are stepped with 8 bits of fraction",
                 [](HistoricRecipe& r) {
                   r.edge_walk = r.span_walk = [walk = r.span_walk](int64_t a, int64_t b,
                                                                    int64_t walked, int64_t steps) {
                     const int64_t from = floor_quotient(a, 256), to = floor_quotient(b, 256);
                     return 256 * walk(from, to, walked, steps);
                   };
                 });
  catalogue->add({k56, k57, kDkit}, "drifts", "MAP", "u gathers 1/64 texel a pixel along a span",
                 [](HistoricRecipe& r) {
                   r.span_walk = [walk = r.span_walk](int64_t a, int64_t b, int64_t walked,
                                                      int64_t steps) {
                     return walk(a, b, walked, steps) + walked * kTexel_fx16 / 64;
                   };
                 });
  catalogue->add({k56, k57}, "walks_from_the_right", "DDA",
                 "the span is stepped from its right end", [](HistoricRecipe& r) {
                   r.span_walk = [walk = r.span_walk](int64_t a, int64_t b, int64_t walked,
                                                      int64_t steps) {
                     return a + b - walk(a, b, steps - walked, steps);
                   };
                 });
  catalogue->add({kDkit}, "edge_texels_not_rounded", "DDA",
                 "texels on the edges keep their fraction",
                 [](HistoricRecipe& r) { r.edge_walk = even_walk; });
  catalogue->add({kDkit}, "steps_of_16_bits", "DDA",
                 "steps along a span are truncated to 16 bits of fraction",
                 [](HistoricRecipe& r) { r.span_walk = truncated_walk; });
  catalogue->add({kDkit}, "rows_of_16_bits", "DDA",
                 "steps down an edge are truncated to 16 bits of fraction", [](HistoricRecipe& r) {
                   r.edge_walk = [](int64_t a, int64_t b, int64_t walked, int64_t steps) {
                     const int64_t at = truncated_walk(a, b, walked, steps) + kTexel_fx16 / 2;
                     return floor_quotient(at, kTexel_fx16) * kTexel_fx16;
                   };
                 });
}

void spoil_q(Catalogue* catalogue) {
  catalogue->add({k56, k57, kDkit}, "equal_q_not_dropped", "AFFINE",
                 "u q is interpolated in single precision and divided by q, although all are equal",
                 [](HistoricRecipe& r) {
                   r.order = [order = r.order](const EdgePoint& a, const EdgePoint& b) {
                     HistoricSpan span = order(a, b);
                     for (EdgePoint* end : {&span.left, &span.right}) {
                       const auto q = static_cast<float>(end->edge.top.q);
                       const float uq = static_cast<float>(end->u_fx16) * q;
                       end->u_fx16 = static_cast<int64_t>(uq / q);
                     }
                     return span;
                   };
                 });
}

}  // namespace

void add_wrong_historic_walks(Catalogue* catalogue) {
  spoil_division(catalogue);
  spoil_width(catalogue);
  spoil_half_steps(catalogue);
  spoil_precision(catalogue);
  spoil_q(catalogue);
}

}  // namespace selvage::coverage
