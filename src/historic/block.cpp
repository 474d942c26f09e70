#include "historic/block.h"

#include <array>
#include <cstddef>

#include "historic/whole_px.h"

namespace selvage::historic {
namespace {

// u - x of a corner, where x is taken one pixel less on the far side.
[[nodiscard]] int64_t shift_fx16(int32_t position_fx8, int32_t texel_fx16, bool far_side) {
  const int64_t pixel = int64_t{whole_px(position_fx8)} - (far_side ? 1 : 0);
  return texel_fx16 - pixel * SELVAGE_SUBTEXELS;
}

}  // namespace

std::optional<BlockShift> block_shift(const mapper::Polygon& polygon) {
  if (polygon.vertices.size() != 4) return std::nullopt;
  std::array<selvage_vertex, 4> corner{};  // from the top left one on, clockwise
  size_t first = polygon.top;              // the first in the list of the one or two on top
  const selvage_vertex& before = polygon.vertices[(first + 3) % 4];
  if (before.y == polygon.vertices[first].y) first = (first + 3) % 4;
  for (size_t i = 0; i < 4; ++i) corner[i] = polygon.vertices[(first + i) % 4];
  const auto& [a, b, c, d] = corner;
  if (a.y != b.y || b.x != c.x || c.y != d.y || d.x != a.x) return std::nullopt;
  if (a.x >= b.x || a.y >= d.y) return std::nullopt;

  const int64_t ds = shift_fx16(a.x, a.u, false), dt = shift_fx16(a.y, a.v, false);
  if (ds % SELVAGE_SUBTEXELS != 0 || dt % SELVAGE_SUBTEXELS != 0) return std::nullopt;
  for (const selvage_vertex& v : corner) {
    if (shift_fx16(v.x, v.u, v.x == b.x) != ds || shift_fx16(v.y, v.v, v.y == d.y) != dt) {
      return std::nullopt;
    }
  }
  return BlockShift{static_cast<int32_t>(ds / SELVAGE_SUBTEXELS),
                    static_cast<int32_t>(dt / SELVAGE_SUBTEXELS)};
}

}  // namespace selvage::historic
