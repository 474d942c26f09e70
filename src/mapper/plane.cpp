#include "mapper/plane.h"

#include <algorithm>

namespace selvage::mapper {

bool Plane::passes_through(const selvage_vertex& vertex) const {
  const selvage_vertex& origin = frame_.origin();
  const int64_t dx = int64_t{vertex.x} - origin.x, dy = int64_t{vertex.y} - origin.y;
  const auto lies_on = [&](int32_t selvage_vertex::*of) {
    const auto [along_x, along_y] = frame_.gradient_of(of);
    return int128{int64_t{vertex.*of} - origin.*of} * frame_.doubled_area() ==
           int128{dx} * along_x + int128{dy} * along_y;
  };
  return lies_on(&selvage_vertex::u) && lies_on(&selvage_vertex::v);
}

bool Plane::holds(std::span<const selvage_vertex> vertices) const {
  return std::ranges::all_of(vertices.subspan(1), [&](const selvage_vertex& vertex) {
    return &vertex == &frame_.second() || &vertex == &frame_.third() || passes_through(vertex);
  });
}

}  // namespace selvage::mapper
