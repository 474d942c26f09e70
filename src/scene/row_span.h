// A face on one scan line, and how near it is at each pixel.
#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>

#include "scene/active_edge.h"
#include "scene/fraction.h"

namespace selvage::scene {

// Covers columns [first_px, end_px). q there is linear between the two edges: at c = 256 i + 128
//
//   (Q_L (X_R - c h_R) + Q_R (c h_L - X_L)) / (h_L X_R - h_R X_L)
//
// with X, Q and h as ActiveEdge has them: numerators below 2^97, denominators below 2^73.
class RowSpan {
 public:
  // The edges in either order.
  RowSpan(const ActiveEdge& a, const ActiveEdge& b);

  [[nodiscard]] size_t face() const { return face_; }
  [[nodiscard]] int32_t first_px() const { return first_px_; }
  [[nodiscard]] int32_t end_px() const { return end_px_; }
  [[nodiscard]] bool empty() const { return first_px_ >= end_px_; }

  // Only columns [0, width_px) are left.
  void clip(int32_t width_px);

  // At a covered column.
  [[nodiscard]] Fraction nearness(int32_t x_px) const;

  // Shows where both cover: nearer, or as near and first in the list of faces.
  [[nodiscard]] bool hides(const RowSpan& other, int32_t x_px) const;

 private:
  size_t face_;
  int32_t first_px_ = 0, end_px_ = 0;
  Signed128 at_origin_ = 0, slope_ = 0, denominator_ = 1;  // of q, in 1/256 px
};

}  // namespace selvage::scene
