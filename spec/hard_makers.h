// The makers of the hard families; spec/hard_cases.cpp names them and says why each is hard.
#pragma once

#include <cstdint>

#include "spec/case.h"

namespace selvage::spec {

// hard_edges.cpp
[[nodiscard]] Case make_sliver(uint64_t seed);
[[nodiscard]] Case make_needle_row(uint64_t seed);
[[nodiscard]] Case make_needle_column(uint64_t seed);
[[nodiscard]] Case make_edges_through_samples(uint64_t seed);
[[nodiscard]] Case make_slopes_45(uint64_t seed);
[[nodiscard]] Case make_slopes_thirds(uint64_t seed);
[[nodiscard]] Case make_near_ties(uint64_t seed);

// hard_extents.cpp
[[nodiscard]] Case make_long_span(uint64_t seed);
[[nodiscard]] Case make_long_edge(uint64_t seed);
[[nodiscard]] Case make_range_ends(uint64_t seed);
[[nodiscard]] Case make_far_off_screen(uint64_t seed);
[[nodiscard]] Case make_magnified_4096(uint64_t seed);
[[nodiscard]] Case make_minified_4096(uint64_t seed);

// hard_outlines.cpp
[[nodiscard]] Case make_repeated_vertices(uint64_t seed);
[[nodiscard]] Case make_collinear_runs(uint64_t seed);
[[nodiscard]] Case make_flat_topped(uint64_t seed);
[[nodiscard]] Case make_flat_bottomed(uint64_t seed);
[[nodiscard]] Case make_unrelated_ngon(uint64_t seed);
[[nodiscard]] Case make_64_gon(uint64_t seed);

// hard_maps.cpp
[[nodiscard]] Case make_texel_boundaries(uint64_t seed);
[[nodiscard]] Case make_least_slopes(uint64_t seed);
[[nodiscard]] Case make_near_planes(uint64_t seed);
[[nodiscard]] Case make_q_ratio_2(uint64_t seed);
[[nodiscard]] Case make_q_ratio_100(uint64_t seed);
[[nodiscard]] Case make_q_ratio_million(uint64_t seed);
[[nodiscard]] Case make_q_equal_one(uint64_t seed);

}  // namespace selvage::spec
