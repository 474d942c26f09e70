#include "historic/block.h"

#include <cstddef>

#include "historic/whole_px.h"

namespace selvage::historic {
namespace {

inline constexpr int64_t kTexel_fx16 = SELVAGE_SUBTEXELS;

// Calls visit(edge's end, edge runs down) for both ends of every edge that crosses a row.
// Horizontal runs, and where their vertices lie, draw nothing.
template <class Visit>
void for_each_edge_end(const mapper::Polygon& polygon, Visit visit) {
  const selvage_vertex* from = &polygon.vertices.back();
  for (const selvage_vertex& to : polygon.vertices) {
    if (from->y != to.y) {
      visit(*from, from->y < to.y);
      visit(to, from->y < to.y);
    }
    from = &to;
  }
}

// What a side of the rectangle must be, from some edge's end on it and one on its top.
struct Rectangle {
  int64_t left_px = 0, right_px = 0, top_px = 0, height_px = 0;
  int64_t left_u_fx16 = 0, right_u_fx16 = 0, top_v_fx16 = 0;

  explicit Rectangle(const mapper::Polygon& polygon)
      : top_px(polygon.top_row), height_px(int64_t{polygon.bottom_row} - polygon.top_row) {
    for_each_edge_end(polygon, [&](const selvage_vertex& v, bool runs_down) {
      (runs_down ? right_px : left_px) = whole_px(v.x);
      (runs_down ? right_u_fx16 : left_u_fx16) = v.u;
      if (whole_px(v.y) == top_px) top_v_fx16 = v.v;
    });
  }

  [[nodiscard]] bool has(const selvage_vertex& v, bool runs_down) const {
    const int64_t down_px = whole_px(v.y) - top_px;
    return whole_px(v.x) == (runs_down ? right_px : left_px) &&
           v.u == (runs_down ? right_u_fx16 : left_u_fx16) &&
           (v.v - top_v_fx16) * height_px == down_px * (height_px - 1) * kTexel_fx16;
  }
};

}  // namespace

std::optional<BlockShift> block_shift(const mapper::Polygon& polygon) {
  if (polygon.top_row == polygon.bottom_row) return std::nullopt;
  const Rectangle rectangle(polygon);
  const int64_t ds_fx16 = rectangle.left_u_fx16 - rectangle.left_px * kTexel_fx16;
  const int64_t dt_fx16 = rectangle.top_v_fx16 - rectangle.top_px * kTexel_fx16;
  if (rectangle.right_u_fx16 - (rectangle.right_px - 1) * kTexel_fx16 != ds_fx16 ||
      ds_fx16 % kTexel_fx16 != 0 || dt_fx16 % kTexel_fx16 != 0) {
    return std::nullopt;
  }
  bool all = true;
  for_each_edge_end(polygon, [&](const selvage_vertex& v, bool runs_down) {
    all = all && rectangle.has(v, runs_down);
  });
  if (!all) return std::nullopt;
  return BlockShift{static_cast<int32_t>(ds_fx16 / kTexel_fx16),
                    static_cast<int32_t>(dt_fx16 / kTexel_fx16)};
}

}  // namespace selvage::historic
