#include "scene/screen_face.h"

#include <algorithm>

namespace selvage::scene {

selvage_status snap(const Outline& outline, double w_near, std::vector<selvage_vertex>& vertices) {
  vertices.clear();
  for (const PlacedCorner& corner : outline) {
    const double w = corner.place.z();
    selvage_vertex vertex;
    const selvage_status status =
        selvage_snap(corner.place.x() / w, corner.place.y() / w, corner.texture_texel.x(),
                     corner.texture_texel.y(), w, w_near, &vertex);
    if (status != SELVAGE_OK) return status;
    vertices.push_back(vertex);
  }
  return SELVAGE_OK;
}

int64_t doubled_area_seen(std::span<const selvage_vertex> vertices) {
  int64_t clockwise = 0;
  for (size_t i = 0; i < vertices.size(); ++i) {
    const selvage_vertex& a = vertices[i];
    const selvage_vertex& b = vertices[(i + 1) % vertices.size()];
    clockwise += int64_t{a.x} * b.y - int64_t{b.x} * a.y;
  }
  return -clockwise;
}

bool is_y_monotone(std::span<const selvage_vertex> vertices) {
  int turns = 0, first = 0, last = 0;
  for (size_t i = 0; i < vertices.size(); ++i) {
    const int32_t a = vertices[i].y, b = vertices[(i + 1) % vertices.size()].y;
    if (a == b) continue;
    const int direction = a < b ? 1 : -1;
    if (first == 0) first = direction;
    turns += last != 0 && direction != last;
    last = direction;
  }
  return turns + (first != last) <= 2;
}

double q_rounding_bound(std::span<const selvage_vertex> vertices) {
  int32_t least = SELVAGE_Q_MAX;
  for (const selvage_vertex& vertex : vertices) least = std::min(least, vertex.q);
  if (least <= 1) return 1;
  const double relative = 1 / (2.0 * least - 1);
  return relative / (2 * (1 - relative));
}

}  // namespace selvage::scene
