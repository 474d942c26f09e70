#include "mapper/outline.h"

#include <cstddef>

namespace selvage::mapper {

// Without a guess: of the lower two, either is as often in the middle.
TriangleCorners Outline::corners() const {
  const selvage_vertex* const v = polygon_->vertices.data();
  const size_t first = polygon_->top, second = first == 2 ? 0 : first + 1,
               third = 3 - first - second;
  const size_t is_second_last = v[second].y > v[third].y;
  const size_t middle = second + is_second_last * (third - second);
  return {v[first], v[middle], v[second + third - middle]};
}

}  // namespace selvage::mapper
