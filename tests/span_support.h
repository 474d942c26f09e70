// Spans of generated cases, for the tests of what walks along them.
#pragma once

#include <algorithm>
#include <cstdint>

#include "mapper/edge.h"
#include "mapper/polygon.h"
#include "mapper/span.h"
#include "spec/generate.h"

namespace selvage::mapper {

// Texels of which nothing is known: no window holds them.
inline constexpr TexelBox kFarApart = {INT32_MIN, INT32_MIN, INT32_MAX, INT32_MAX};

// More than all pixels that a polygon may have.
inline constexpr selvage_rect kEverywhere{-40000, -40000, 40000, 40000};

// Calls visit(left, right, span) for rows of a polygon between two columns, at their edges.
template <class Visit>
void for_each_row(const Polygon& polygon, int32_t first_row, int32_t end_row, int32_t first_px,
                  int32_t end_px, Visit visit) {
  Chain forward(polygon, Chain::Direction::kForward),
      backward(polygon, Chain::Direction::kBackward);
  end_row = std::min(polygon.bottom_row, end_row);
  for (int32_t row = std::max(polygon.top_row, first_row); row < end_row; ++row) {
    const Edge& a = forward.at_row(row);
    const Edge& b = backward.at_row(row);
    const auto [left, right] =
        std::minmax(a, b, [](const Edge& e, const Edge& f) { return e.first_px() < f.first_px(); });
    const Span span{row, std::max(left.first_px(), first_px), std::min(right.first_px(), end_px)};
    if (!span.empty()) visit(left, right, span);
  }
}

// Calls visit(case, polygon, map, span) for the spans of a case, up to 2 px beyond its target's
// sides.
template <class Visit>
void for_each_span(const spec::Case& c, Visit visit) {
  Polygon polygon;
  if (examine(c.vertices, &polygon) != SELVAGE_OK) return;
  for_each_row(polygon, 0, c.target_height_px, -2, c.target_width_px + 2,
               [&](const Edge& left, const Edge& right, const Span& span) {
                 visit(c, polygon, SpanMap(left.at(span.row), right.at(span.row)), span);
               });
}

template <class Visit>
void for_each_generated_span(uint64_t cases, Visit visit) {
  for (uint64_t seed = 1; seed <= cases; ++seed) for_each_span(spec::generate(seed), visit);
}

}  // namespace selvage::mapper
