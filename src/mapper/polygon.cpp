#include "mapper/polygon.h"

#include "mapper/number.h"

namespace selvage::mapper {
namespace {

[[nodiscard]] bool position_in_range(int32_t position_fx8) {
  return SELVAGE_X_MIN <= position_fx8 && position_fx8 < SELVAGE_X_END;
}

[[nodiscard]] selvage_status check_ranges(std::span<const selvage_vertex> vertices) {
  for (const selvage_vertex& v : vertices) {
    if (!position_in_range(v.x) || !position_in_range(v.y)) return SELVAGE_ERROR_VERTEX_POSITION;
    if (v.q < 1 || v.q > SELVAGE_Q_MAX) return SELVAGE_ERROR_VERTEX_Q;
  }
  return SELVAGE_OK;
}

// A closed outline crosses every scan line at most twice if and only if its edges, horizontal ones
// apart, turn from down to up once around, and from up to down once. One of the two turns may lie
// where the loop starts and ends, unseen; with more than two, three at least are seen.
[[nodiscard]] bool is_monotone(std::span<const selvage_vertex> vertices) {
  int turns = 0;
  int32_t last = 0;  // direction: +1 down, -1 up, 0 none yet
  const selvage_vertex* from = &vertices.back();
  for (const selvage_vertex& to : vertices) {
    const int32_t direction = (to.y > from->y) - (to.y < from->y);
    from = &to;
    if (direction == 0) continue;
    if (last != 0 && direction != last) ++turns;
    last = direction;
  }
  return turns <= 2;
}

}  // namespace

selvage_status examine(std::span<const selvage_vertex> vertices, Polygon* polygon) {
  if (vertices.size() < 3) return SELVAGE_ERROR_VERTEX_COUNT;
  const selvage_status ranges = check_ranges(vertices);
  if (ranges != SELVAGE_OK) return ranges;
  if (!is_monotone(vertices)) return SELVAGE_ERROR_NOT_MONOTONE;

  *polygon = Polygon{.vertices = vertices};
  int32_t bottom_fx8 = vertices[0].y;
  for (size_t i = 1; i < vertices.size(); ++i) {
    if (vertices[i].y < vertices[polygon->top].y) polygon->top = i;
    if (vertices[i].y > bottom_fx8) bottom_fx8 = vertices[i].y;
    if (vertices[i].q != vertices[0].q) polygon->affine = false;
  }
  polygon->top_row = first_centre_px(vertices[polygon->top].y);
  polygon->bottom_row = first_centre_px(bottom_fx8);
  return SELVAGE_OK;
}

}  // namespace selvage::mapper
