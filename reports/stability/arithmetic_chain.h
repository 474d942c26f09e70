// The outline's two sides, top down, and the rows they span. Heights have 24 bits, so every
// arithmetic finds the same rows: the rounding is in x, u and v.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "reports/stability/arithmetic_call.h"
#include "selvage.h"

namespace selvage::stability {

// The first pixel whose centre is at or beyond the place, along x or y: ceil(place - 1/2).
[[nodiscard]] constexpr int32_t first_centre_px(int32_t place_fx8) {
  constexpr int32_t half = SELVAGE_SUBPIXELS / 2;
  return (place_fx8 + half - 1) >> 8;
}

// A side, from a vertex of least y. Its edges cross the rows' centres one after the other;
// horizontal ones, and those between two centres, cross none and are passed over.
class Chain {
 public:
  // step: 1 is forward through the outline, its size - 1 backward.
  Chain(std::span<const selvage_vertex> outline, size_t top, size_t step)
      : outline_(outline), step_(step), top_(top), bottom_(top) {}

  // Goes down to the edge that crosses the centre of row y, which must not be above the one before
  // and must lie within the outline. True if that is another edge than before.
  bool go_to(int32_t y_px) {
    if (first_centre_px(bottom().y) > y_px) return false;
    while (first_centre_px(bottom().y) <= y_px) {
      top_ = bottom_;
      bottom_ = (bottom_ + step_) % outline_.size();
    }
    return true;
  }

  [[nodiscard]] const selvage_vertex& top() const { return outline_[top_]; }
  [[nodiscard]] const selvage_vertex& bottom() const { return outline_[bottom_]; }

 private:
  std::span<const selvage_vertex> outline_;
  size_t step_, top_, bottom_;
};

// Walks both sides down the visible rows: Edge is made of two vertices and the row it starts in,
// and steps from row to row. paint(y, a, b) gets the edges as they are at the row's centre; which
// of them is the left one it has to find out.
template <class Edge, class Paint>
void for_each_row(const Call& call, const Paint& paint) {
  const auto& outline = call.outline;
  const auto [top, bottom] = std::minmax_element(
      outline.begin(), outline.end(), [](const auto& a, const auto& b) { return a.y < b.y; });
  const int32_t first = std::max(first_centre_px(top->y), call.visible.top);
  const int32_t end = std::min(first_centre_px(bottom->y), call.visible.bottom);
  const auto start = static_cast<size_t>(top - outline.begin());
  Chain forward(outline, start, 1), backward(outline, start, outline.size() - 1);
  Edge a, b;
  for (int32_t y = first; y < end; ++y) {
    if (forward.go_to(y)) a = Edge(forward.top(), forward.bottom(), y);
    if (backward.go_to(y)) b = Edge(backward.top(), backward.bottom(), y);
    paint(y, a, b);
    a.step();
    b.step();
  }
}

}  // namespace selvage::stability
