#include "historic/classroom.h"

#include <algorithm>
#include <compare>
#include <cstddef>
#include <limits>

#include "historic/rounded_walk.h"
#include "historic/texel_row.h"
#include "historic/whole_px.h"
#include "mapper/image.h"

namespace selvage::historic {
namespace {

// Where an edge meets a scan line: E and T of the notes. The order makes the lesser column the
// left end; in one column it picks the same texel whichever way the outline runs.
struct EdgeEnd {
  int32_t column_px, s, t;
  friend auto operator<=>(const EdgeEnd&, const EdgeEnd&) = default;
};

// One of the two chains of edges from top to bottom. A row where one edge ends and the next begins
// belongs to the next, the polygon's last row to the last edge.
class ClassroomChain {
 public:
  enum class Direction { kForward, kBackward };  // through the vertices
  ClassroomChain(const mapper::Polygon& polygon, Direction direction)
      : polygon_(&polygon), direction_(direction), end_vertex_(polygon.top) {}

  // Rows rise from call to call, within [top_row, bottom_row].
  [[nodiscard]] EdgeEnd at_row(int32_t row) {
    while (row >= end_row_ && end_row_ < polygon_->bottom_row) next_edge();
    const int64_t rows = int64_t{row} - row_;
    for (RoundedWalk* walk : {&column_, &s_, &t_}) walk->advance(rows);
    row_ = row;
    return {column_.texel(), s_.texel(), t_.texel()};
  }

 private:
  void next_edge() {
    const size_t count = polygon_->vertices.size();
    const selvage_vertex& from = polygon_->vertices[end_vertex_];
    end_vertex_ = (end_vertex_ + (direction_ == Direction::kForward ? 1 : count - 1)) % count;
    const selvage_vertex& to = polygon_->vertices[end_vertex_];
    row_ = whole_px(from.y);
    end_row_ = whole_px(to.y);
    const int64_t height = int64_t{end_row_} - row_;
    if (height == 0) return;  // crosses no row: at_row passes it by
    column_ = RoundedWalk(whole_px(from.x), whole_px(to.x), height, 1);
    s_ = RoundedWalk(from.u, to.u, height, SELVAGE_SUBTEXELS);
    t_ = RoundedWalk(from.v, to.v, height, SELVAGE_SUBTEXELS);
  }

  const mapper::Polygon* polygon_;
  Direction direction_;
  size_t end_vertex_;  // of the current edge
  int32_t row_ = 0, end_row_ = std::numeric_limits<int32_t>::min();
  RoundedWalk column_, s_, t_;
};

[[nodiscard]] RoundedWalk span_walk(int32_t first_texel, int32_t last_texel, int32_t steps,
                                    int32_t skipped_px) {
  if (steps == 0) return RoundedWalk(first_texel, first_texel, 1, 1);  // one pixel
  RoundedWalk walk(first_texel, last_texel, steps, 1);
  walk.advance(skipped_px);
  return walk;
}

}  // namespace

void draw_classroom(const selvage_image& target, const selvage_rect& visible,
                    const mapper::Polygon& polygon, const selvage_texture& texture,
                    selvage_address address) {
  if (polygon.top_row == polygon.bottom_row) return;  // no scan line crosses an edge
  ClassroomChain forward(polygon, ClassroomChain::Direction::kForward);
  ClassroomChain backward(polygon, ClassroomChain::Direction::kBackward);

  const int32_t end_row = std::min(polygon.bottom_row + 1, visible.bottom);
  for (int32_t row = std::max(polygon.top_row, visible.top); row < end_row; ++row) {
    const EdgeEnd a = forward.at_row(row), b = backward.at_row(row);
    const EdgeEnd left = std::min(a, b), right = std::max(a, b);
    const int32_t first_px = std::max(left.column_px, visible.left);
    const int32_t end_px = std::min(right.column_px + 1, visible.right);
    if (first_px >= end_px) continue;

    const int32_t steps = right.column_px - left.column_px;
    const int32_t skipped_px = first_px - left.column_px;
    const TexelRow pixels{static_cast<char*>(target.pixels) + row * target.pitch +
                              first_px * mapper::bytes_per_pixel(target.format),
                          end_px - first_px, texture, address};
    write_row(pixels, span_walk(left.s, right.s, steps, skipped_px),
              span_walk(left.t, right.t, steps, skipped_px));
  }
}

}  // namespace selvage::historic
