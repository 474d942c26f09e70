// The outline: a polygon's edges as its rows meet them.
#pragma once

#include <cstddef>
#include <optional>

#include "mapper/edge.h"
#include "mapper/polygon.h"

namespace selvage::mapper {

// A triangle's vertices from top to bottom. One edge goes all the way down; on the other side the
// lower one follows the upper.
struct TriangleCorners {
  const selvage_vertex &top, &middle, &bottom;
};

// From a polygon's top to its bottom; of the two, the left one is decided row by row.
struct Chains {
  Chain forward, backward;
};

class Outline {
 public:
  explicit Outline(const Polygon& polygon) : polygon_(&polygon) {}

  // Made when they are first asked for: a triangle's rows need no walk.
  [[nodiscard]] Chains& chains() {
    if (!chains_) {
      chains_.emplace(Chain(*polygon_, Chain::Direction::kForward),
                      Chain(*polygon_, Chain::Direction::kBackward));
    }
    return *chains_;
  }

  [[nodiscard]] bool is_triangle() const { return polygon_->vertices.size() == 3; }
  // Found without a guess: of the lower two, either is as often in the middle.
  [[nodiscard]] TriangleCorners corners() const {
    const selvage_vertex* const v = polygon_->vertices.data();
    const size_t first = polygon_->top, second = first == 2 ? 0 : first + 1,
                 third = 3 - first - second;
    const size_t is_second_last = v[second].y > v[third].y;
    const size_t middle = second + is_second_last * (third - second);
    return {v[first], v[middle], v[second + third - middle]};
  }

 private:
  const Polygon* polygon_;
  std::optional<Chains> chains_;
};

}  // namespace selvage::mapper
