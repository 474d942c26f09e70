#include "mapper/plane.h"

#include <algorithm>

namespace selvage::mapper {

// The pixels that the lanes are of, and what they lack at most; no start and no steps yet.
Plane::Plane(const Polygon& polygon, const selvage_rect& visible)
    : frame_(PlaneFrame::of(polygon.vertices)) {
  lanes_.first_px = std::max(visible.left, polygon.left_px);
  lanes_.first_row = std::max(visible.top, polygon.top_row);
  const int32_t end_px = std::min(visible.right, polygon.right_px);
  const int32_t end_row = std::min(visible.bottom, polygon.bottom_row);
  const int32_t steps = std::max(end_px - lanes_.first_px + end_row - lanes_.first_row, 0) + 1;
  lanes_.margin_fx32 = kPlaneErrorPerStep_fx32 * static_cast<uint32_t>(steps);
}

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

bool Plane::is_of(std::span<const selvage_vertex> vertices) const {
  if (frame_.doubled_area() == 0) return false;
  const auto is_on = [&](const selvage_vertex& vertex) { return passes_through(vertex); };
  return vertices.size() == 3 || std::ranges::all_of(vertices.subspan(1), is_on);
}

// The plane is made in its place: a copy would load by sixteens of bytes what was just stored by
// eights, and wait for it.
std::optional<Plane> Plane::of(const Polygon& polygon, const selvage_rect& visible,
                               FindLanes find_lanes) {
  std::optional<Plane> plane(std::in_place, polygon, visible);
  if (!polygon.affine || !plane->is_of(polygon.vertices) ||
      !find_lanes(plane->frame_, &plane->lanes_)) {
    plane.reset();
  }
  return plane;
}

}  // namespace selvage::mapper
