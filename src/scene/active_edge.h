// An edge while scan lines cross it: its x and q, stepped from row to row without error.
#pragma once

#include <cstddef>
#include <cstdint>

#include "selvage.h"

namespace selvage::scene {

// Crosses the centres of rows [first_row, end_row): y_top <= centre < y_bottom.
struct EdgeRows {
  int32_t first_row, end_row;
};
[[nodiscard]] constexpr EdgeRows rows_between(int32_t top_fx8, int32_t bottom_fx8) {
  const int32_t before_centre = SELVAGE_SUBPIXELS / 2 - 1;
  return {(top_fx8 + before_centre) >> 8, (bottom_fx8 + before_centre) >> 8};
}

// At height y the edge is at x / height (1/256 px) and has q / height, height = y_bottom - y_top.
// With b = y - y_top both are a (height - b) + b' b, a at the top and b' at the bottom, so a row
// down adds 256 (b' - a). |x| <= 2^23 height < 2^47 and q <= 2^24 height <= 2^48.
class ActiveEdge {
 public:
  ActiveEdge(size_t face, const selvage_vertex& top, const selvage_vertex& bottom, int32_t row)
      : face_(face),
        end_row_(rows_between(top.y, bottom.y).end_row),
        height_(int64_t{bottom.y} - top.y),
        x_step_(int64_t{SELVAGE_SUBPIXELS} * (int64_t{bottom.x} - top.x)),
        q_step_(int64_t{SELVAGE_SUBPIXELS} * (int64_t{bottom.q} - top.q)) {
    const int64_t below_top = int64_t{row} * SELVAGE_SUBPIXELS + SELVAGE_SUBPIXELS / 2 - top.y;
    x_ = top.x * (height_ - below_top) + bottom.x * below_top;
    q_ = top.q * (height_ - below_top) + bottom.q * below_top;
  }

  void step() {
    x_ += x_step_;
    q_ += q_step_;
  }

  [[nodiscard]] size_t face() const { return face_; }
  [[nodiscard]] int32_t end_row() const { return end_row_; }
  [[nodiscard]] int64_t height() const { return height_; }
  [[nodiscard]] int64_t x() const { return x_; }
  [[nodiscard]] int64_t q() const { return q_; }

  // The first pixel whose centre is at the edge or right of it: ceil((x - 128 h) / (256 h)).
  [[nodiscard]] int32_t first_px() const {
    const int64_t unit = SELVAGE_SUBPIXELS * height_;
    const int64_t numerator = x_ + unit / 2 - 1;  // of the floor that the ceiling is
    const int64_t quotient = numerator / unit;
    return static_cast<int32_t>(quotient - (numerator % unit < 0));
  }

 private:
  size_t face_;
  int32_t end_row_;
  int64_t height_, x_ = 0, q_ = 0, x_step_, q_step_;
};

}  // namespace selvage::scene
