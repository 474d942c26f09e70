// The outline: a polygon's edges as its rows meet them.
#pragma once

#include <cstdint>

#include "mapper/edge.h"
#include "mapper/polygon.h"

namespace selvage::mapper {

// A triangle's edges. One goes all the way down; on the other side the lower one follows the upper.
struct TriangleLines {
  EdgeLine whole, upper, lower;
  int32_t upper_rows;  // from the row that the lines start at; may be none, or more than there are
};

class Outline {
 public:
  explicit Outline(const Polygon& polygon)
      : polygon_(&polygon),
        forward_(polygon, Chain::Direction::kForward),
        backward_(polygon, Chain::Direction::kBackward) {}

  // From the polygon's top to its bottom; of the two, the left one is decided row by row.
  [[nodiscard]] Chain* forward() { return &forward_; }
  [[nodiscard]] Chain* backward() { return &backward_; }

  [[nodiscard]] bool is_triangle() const { return polygon_->vertices.size() == 3; }
  // Of a triangle that has rows. They go on where their edges do not, but mean nothing there: one
  // whose edge crosses no row may have no height.
  [[nodiscard]] TriangleLines lines_from(int32_t row) const {
    const selvage_vertex* const v = polygon_->vertices.data();
    const size_t first = polygon_->top, second = first == 2 ? 0 : first + 1,
                 third = 3 - first - second;
    const bool in_order = v[second].y <= v[third].y;
    const selvage_vertex &top = v[first], &middle = v[in_order ? second : third],
                         &bottom = v[in_order ? third : second];
    return {line_between(top, bottom, row), line_between(top, middle, row),
            line_between(middle, bottom, row), first_centre_px(middle.y) - row};
  }

 private:
  const Polygon* polygon_;
  Chain forward_, backward_;
};

}  // namespace selvage::mapper
