// A span: the visible pixels of one scan line between two edges, and the exact map along them.
#pragma once

#include <cstdint>

#include "mapper/edge.h"
#include "mapper/number.h"

namespace selvage::mapper {

// Columns [left_px, right_px) of a row.
struct Span {
  int32_t row, left_px, right_px;

  [[nodiscard]] bool empty() const { return left_px >= right_px; }
  [[nodiscard]] int32_t width_px() const { return right_px - left_px; }
};

// u = u_numerator / denominator in texels, at the centre of a pixel between the two edges; all
// three are linear along the span. With weights w to the other edge's point, (u q, q) is their
// mean:
//   u = (left.uq w_left + right.uq w_right) / (left.q w_left + right.q w_right)
// for the common factor 1 / (height_left height_right width) cancels. The three fit 128 bits at
// pixels between the edges (number.h); elsewhere they are right modulo 2^128.
class SpanMap {
 public:
  SpanMap(const EdgePoint& left, const EdgePoint& right) : left_(left), right_(right) {}

  [[nodiscard]] int128 u_numerator(int32_t px) const { return mean(left_.uq, right_.uq, px); }
  [[nodiscard]] int128 v_numerator(int32_t px) const { return mean(left_.vq, right_.vq, px); }
  [[nodiscard]] int128 denominator(int32_t px) const {
    return mean(left_.q, right_.q, px) << kTexelFraction;
  }

  // Change from a pixel to the next one.
  [[nodiscard]] int128 u_numerator_step() const {
    return (right_.uq * left_.height - left_.uq * right_.height) * kSubpixels;
  }
  [[nodiscard]] int128 v_numerator_step() const {
    return (right_.vq * left_.height - left_.vq * right_.height) * kSubpixels;
  }
  [[nodiscard]] int128 denominator_step() const {
    return ((int128{right_.q} * left_.height - int128{left_.q} * right_.height) * kSubpixels)
           << kTexelFraction;
  }

 private:
  [[nodiscard]] int128 mean(int128 left, int128 right, int32_t px) const {
    const auto product = [](int128 a, int64_t b) {
      return static_cast<uint128>(a) * static_cast<uint128>(int128{b});
    };
    return static_cast<int128>(product(left, weight_left(px)) + product(right, weight_right(px)));
  }

  // Distances from the pixel's centre to the other edge, times both heights: >= 0 within the span.
  [[nodiscard]] int64_t weight_left(int32_t px) const {
    return right_.x - centre_fx8(px) * right_.height;
  }
  [[nodiscard]] int64_t weight_right(int32_t px) const {
    return centre_fx8(px) * left_.height - left_.x;
  }

  EdgePoint left_, right_;
};

}  // namespace selvage::mapper
