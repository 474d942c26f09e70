#include "spec/hard_cases.h"

#include "spec/hard_makers.h"

namespace selvage::spec {
namespace {

constexpr HardFamily kHardFamilies[] = {
    {"slivers",
     "Triangles down to 1/65536 square pixel: gradients divided by an area of nearly 0 blow "
     "up, and rounding decides whether a centre is covered.",
     make_sliver},
    {"needle-rows",
     "One row of centres high and as wide as the target: a start that is not moved from the "
     "edge to the centre is wrong by up to the whole height of the texture, all along the row.",
     make_needle_row},
    {"needle-columns",
     "One column of centres wide and as high as the target: spans of 0 or 1 px divide by their "
     "width, and a pixel left out is a hole in every row.",
     make_needle_column},
    {"long-spans",
     "Spans of 30 000 px and more: a step rounded to 1/65536 texel is up to a quarter of a "
     "texel off at their end, and a start far left of the clip must be carried there.",
     make_long_span},
    {"long-edges",
     "Edges of 30 000 rows and more: the errors of a step down the edge add up, in x and in "
     "the texture.",
     make_long_edge},
    {"edges-through-samples",
     "Edges exactly through pixel centres: a centre is drawn twice or never where both ends of "
     "a span are closed, both open, or rounded.",
     make_edges_through_samples},
    {"slopes-45",
     "Edges and texture at 45 degrees through centres: each row has a tie at its ends and each "
     "pixel one in u and v, so a rule for ties that changes sides shows everywhere.",
     make_slopes_45},
    {"slopes-thirds",
     "Slopes of 1/3 and 3 in edges and texture: no binary fraction is a third, so each third "
     "sample is a tie that a rounded slope misses.",
     make_slopes_thirds},
    {"near-ties",
     "Edges that miss a centre, and coordinates that miss a texel's border, by the least the "
     "grid allows: one unit in the last place of any rounded number decides.",
     make_near_ties},
    {"range-ends",
     "Vertices at the ends of the range, edges across all of it: differences take one bit more "
     "than positions, and their products overflow.",
     make_range_ends},
    {"far-off-screen",
     "Every vertex thousands of pixels off, the target inside: all of the picture depends on "
     "how the edges and the map are carried to the clip.",
     make_far_off_screen},
    {"magnified-4096",
     "One texel over 4 096 px: the step is 16/65536 texel, so its rounding moves the border "
     "between two texels by up to hundreds of pixels.",
     make_magnified_4096},
    {"minified-4096",
     "4 096 texels into 3 px: an error of 1/256 px in where an edge or a centre lies is five "
     "texels.",
     make_minified_4096},
    {"texel-boundaries",
     "u and v a whole number at every centre: the least error downward, or a rounding where a "
     "floor belongs, shows the neighbour.",
     make_texel_boundaries},
    {"least-slopes",
     "A quadrilateral that no plane holds, and a row of it that changes by less than a millionth "
     "of a texel from end to end, beside a border: a slope rounded to the other sign walks over "
     "it.",
     make_least_slopes},
    {"near-planes",
     "A quadrilateral that no plane holds, for one corner's u and v are some 65536ths of a texel "
     "off a plane that has whole numbers at every centre: who takes that plane for the map, or "
     "rounds by as much, shows the neighbour.",
     make_near_planes},
    {"repeated-vertices",
     "Each vertex several times: edges without length divide by 0, or a twin is taken for the "
     "other end of the next edge.",
     make_repeated_vertices},
    {"collinear-runs",
     "Vertices along straight edges: a walk that starts afresh at each of them loses the "
     "fraction it had, in x and in the texture.",
     make_collinear_runs},
    {"flat-topped",
     "A horizontal run on top, on a row of centres too: the two upper ends are not one vertex, "
     "and the row on the top edge must be drawn.",
     make_flat_topped},
    {"flat-bottomed",
     "A horizontal run at the bottom, on a row of centres too: the row on the bottom edge must "
     "not be drawn, nor any edge be read past its end.",
     make_flat_bottomed},
    {"unrelated-ngons",
     "Convex outlines whose texture polygon has another shape: no one gradient holds for all "
     "of the polygon, and cutting it into triangles draws another picture.",
     make_unrelated_ngon},
    {"64-gons",
     "Sixty-four corners: tables for a few edges overflow, edges of a row or less are skipped, "
     "and the texture must stay in one piece across all of them.",
     make_64_gon},
    {"q-ratio-2",
     "Depths in the ratio 2: mild, yet a map without perspective, or divided only at the ends "
     "of a span, is tens of texels off.",
     make_q_ratio_2},
    {"q-ratio-100",
     "Depths in the ratio 100: most of the texture lies in a small part of the span, where a "
     "division every 16 px is far too coarse.",
     make_q_ratio_100},
    {"q-ratio-million",
     "Depths in the ratio 1 000 000, to a horizon: of the 24 bits of single precision 20 are "
     "spent on the near end, and little is left of q at the far one.",
     make_q_ratio_million},
    {"q-equal-one",
     "q = 1, the least there is, on a one-to-one copy with centres on texel boundaries: a "
     "division by interpolated q, or its reciprocal, ends a hair below the whole texel.",
     make_q_equal_one},
};

}  // namespace

std::span<const HardFamily> hard_families() { return kHardFamilies; }

const HardFamily* find_hard_family(std::string_view name) {
  for (const HardFamily& family : kHardFamilies) {
    if (family.name == name) return &family;
  }
  return nullptr;
}

}  // namespace selvage::spec
