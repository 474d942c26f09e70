// The outline: a polygon's edges as its rows meet them.
#pragma once

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
  // Of a triangle.
  [[nodiscard]] TriangleCorners corners() const;

 private:
  const Polygon* polygon_;
  std::optional<Chains> chains_;
};

}  // namespace selvage::mapper
