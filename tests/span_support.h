// Spans of generated cases, for the tests of what walks along them.
#pragma once

#include <algorithm>
#include <cstdint>

#include "mapper/edge.h"
#include "mapper/polygon.h"
#include "mapper/span.h"
#include "spec/generate.h"

namespace selvage::mapper {

// Calls visit(case, polygon, map, span) for the spans of a case, up to 2 px beyond its target's
// sides.
template <class Visit>
void for_each_span(const spec::Case& c, Visit visit) {
  Polygon polygon;
  if (examine(c.vertices, &polygon) != SELVAGE_OK) return;
  Chain forward(polygon, Chain::Direction::kForward),
      backward(polygon, Chain::Direction::kBackward);
  const int32_t end_row = std::min(polygon.bottom_row, c.target_height_px);
  for (int32_t row = std::max(polygon.top_row, 0); row < end_row; ++row) {
    const Edge& a = forward.at_row(row);
    const Edge& b = backward.at_row(row);
    const auto [left, right] =
        std::minmax(a, b, [](const Edge& e, const Edge& f) { return e.first_px() < f.first_px(); });
    const Span span{row, std::max(left.first_px(), -2),
                    std::min(right.first_px(), c.target_width_px + 2)};
    if (!span.empty()) visit(c, polygon, SpanMap(left.at(row), right.at(row)), span);
  }
}

template <class Visit>
void for_each_generated_span(uint64_t cases, Visit visit) {
  for (uint64_t seed = 1; seed <= cases; ++seed) for_each_span(spec::generate(seed), visit);
}

}  // namespace selvage::mapper
