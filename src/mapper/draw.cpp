#include "mapper/draw.h"

#include <algorithm>

#include "mapper/edge.h"
#include "mapper/row_kernel.h"
#include "mapper/span.h"

namespace selvage::mapper {

void draw(const selvage_image& target, const selvage_rect& visible, const Polygon& polygon,
          const selvage_texture& texture, selvage_address address) {
  const RowKernel draw_row = row_kernel(target.format, polygon.affine);
  Chain forward(polygon, Chain::Direction::kForward);
  Chain backward(polygon, Chain::Direction::kBackward);

  const int32_t end_row = std::min(polygon.bottom_row, visible.bottom);
  for (int32_t row = std::max(polygon.top_row, visible.top); row < end_row; ++row) {
    const Edge& a = forward.at_row(row);
    const Edge& b = backward.at_row(row);
    const bool a_is_left = a.first_px() <= b.first_px();
    const Edge& left = a_is_left ? a : b;
    const Edge& right = a_is_left ? b : a;

    const Span span{.row = row,
                    .left_px = std::max(left.first_px(), visible.left),
                    .right_px = std::min(right.first_px(), visible.right)};
    if (span.empty()) continue;
    const SpanMap map(left.at(row), right.at(row));
    draw_row(map, span, texture, address, static_cast<char*>(target.pixels) + row * target.pitch);
  }
}

}  // namespace selvage::mapper
