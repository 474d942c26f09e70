#include "mapper/polygon.h"

#include <algorithm>

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
    turns += direction * last < 0 ? 1 : 0;
    last = direction != 0 ? direction : last;
  }
  return turns <= 2;
}

// u - x, in 1/65536 of either unit.
[[nodiscard]] int64_t shift_fx16(int32_t position_fx8, int32_t texel_fx16) {
  return int64_t{texel_fx16} - (int64_t{position_fx8} << (kTexelFraction - kSubpixelBits));
}

[[nodiscard]] bool is_whole(int64_t fx16) {
  return (fx16 & ((int64_t{1} << kTexelFraction) - 1)) == 0;
}

// One shift for all vertices is one shift for all that is interpolated between them.
void find_shift(Polygon* polygon) {
  const selvage_vertex& first = polygon->vertices[0];
  const int64_t ds = shift_fx16(first.x, first.u), dt = shift_fx16(first.y, first.v);
  polygon->untransformed = polygon->affine && is_whole(ds) && is_whole(dt);
  if (!polygon->untransformed) return;
  for (const selvage_vertex& v : polygon->vertices) {
    if (shift_fx16(v.x, v.u) != ds || shift_fx16(v.y, v.v) != dt) polygon->untransformed = false;
  }
  polygon->ds = static_cast<int32_t>(ds >> kTexelFraction);
  polygon->dt = static_cast<int32_t>(dt >> kTexelFraction);
}

}  // namespace

selvage_status examine(std::span<const selvage_vertex> vertices, Polygon* polygon) {
  if (vertices.size() < 3) return SELVAGE_ERROR_VERTEX_COUNT;
  const selvage_status ranges = check_ranges(vertices);
  if (ranges != SELVAGE_OK) return ranges;
  // A triangle turns twice at most.
  if (vertices.size() > 3 && !is_monotone(vertices)) return SELVAGE_ERROR_NOT_MONOTONE;

  // Field by field: a whole Polygon would be copied by sixteens of bytes from where it was just
  // made by eights, and wait for it.
  polygon->vertices = vertices;
  polygon->top = 0;
  polygon->affine = true;
  const selvage_vertex& first = vertices[0];
  int32_t top_fx8 = first.y, bottom_fx8 = first.y, left_fx8 = first.x, right_fx8 = first.x;
  TexelBox texels{first.u, first.u, first.v, first.v};
  for (size_t i = 1; i < vertices.size(); ++i) {
    const selvage_vertex& v = vertices[i];
    if (v.y < top_fx8) polygon->top = i;
    top_fx8 = std::min(top_fx8, v.y);
    bottom_fx8 = std::max(bottom_fx8, v.y);
    left_fx8 = std::min(left_fx8, v.x);
    right_fx8 = std::max(right_fx8, v.x);
    texels.least_u_fx16 = std::min(texels.least_u_fx16, v.u);
    texels.most_u_fx16 = std::max(texels.most_u_fx16, v.u);
    texels.least_v_fx16 = std::min(texels.least_v_fx16, v.v);
    texels.most_v_fx16 = std::max(texels.most_v_fx16, v.v);
    if (v.q != first.q) polygon->affine = false;
  }
  polygon->top_row = first_centre_px(top_fx8);
  polygon->bottom_row = first_centre_px(bottom_fx8);
  polygon->left_px = first_centre_px(left_fx8);
  polygon->right_px = first_centre_px(right_fx8);
  polygon->texels = texels;
  find_shift(polygon);
  return SELVAGE_OK;
}

}  // namespace selvage::mapper
