// What a polygon costs the inexact loops before its first row: edges in 32.32, gradients in double.
// No rounding is accounted for.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "reports/bench/planes.h"
#include "reports/bench/spans.h"
#include "selvage.h"

namespace selvage::reports {

struct InexactEdge {
  int32_t first_row_px = 0, end_row_px = 0;
  int64_t x_fx32 = 0, step_fx32 = 0;  // less 1/2, so that the first covered column is its ceil
};

// Texels of one coordinate, both of them included.
struct TexelRange {
  int32_t first = 0, last = 0;
};

struct InexactPolygon {
  std::array<InexactEdge, kMaxPolygonVertices> edges;  // highest first
  size_t edge_count = 0;
  // At a column's and a row's number. Affine: in 1/65536 texel. Else u q and v q in texels, and q
  // scaled to 1 at the first vertex.
  Plane u, v, q;
  bool affine = true;
  TexelRange columns, rows;  // that the vertices lie in, and what rounding may make of it
};

// Of a polygon whose map is affine or projective throughout, and whose first, second and last
// vertex are not collinear.
[[nodiscard]] InexactPolygon inexact_polygon(std::span<const selvage_vertex> polygon,
                                             int32_t height_px);

}  // namespace selvage::reports
