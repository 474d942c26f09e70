// The line between two texels: on which side of it pixels lie.
#pragma once

#include <cmath>
#include <cstdint>

#include "mapper/exact_row.h"
#include "mapper/number.h"
#include "mapper/span.h"

namespace selvage::mapper {

// Where a coordinate n / d is a whole number k. As d > 0 at all pixels, they are at the line or
// beyond it where n - k d >= 0. That is linear, so that what holds for two pixels of a row holds
// for those between them, and it changes its sign once.
//
// It is evaluated in double: three numbers converted, two products, two sums and one product more
// are off by less than 5 * 2^-53 of the sum of their magnitudes, which is less than kDoubt of it
// as that is rounded. Where all three numbers are 0, so is the difference, and it is told exactly.
class Boundary {
 public:
  Boundary() = default;
  // Of u or v in units of 2^-bits texel, by a pixel of the map and the one below it.
  Boundary(const ExactMap& map, ExactLine ExactRow::*coordinate, int bits, int32_t whole,
           int32_t px, int32_t row)
      : px_(px), row_(row) {
    const auto k = static_cast<uint128>(int128{whole});
    const ExactRow here = map.row_from(px, row), below = map.row_from(px, row + 1);
    const ExactLine n = here.*coordinate, d = here.finer_d(bits);
    const uint128 start = n.start - k * d.start;
    start_ = to_double(start);
    right_ = to_double(n.step - k * d.step);
    down_ = to_double((below.*coordinate).start - k * below.finer_d(bits).start - start);
  }

  // Of some pixels of a row, how many at its left are on one side, all others being on the other
  // one; -1 where that is not certain.
  struct Sides {
    int32_t left_px;
    bool left_beyond;
  };
  [[nodiscard]] Sides sides_of(const Span& pixels) const {
    const double right = (pixels.left_px - px_) * right_, down = (pixels.row - row_) * down_;
    const double last_px = pixels.width_px() - 1;
    const double first = start_ + right + down, last = first + last_px * right_;
    const double doubt =
        kDoubt * (std::abs(start_) + std::abs(right) + std::abs(down) + last_px * std::abs(right_));
    const int at_first = side(first, doubt), at_last = side(last, doubt);
    if (at_first == 0 || at_last == 0) return {-1, false};
    if (at_first == at_last) return {pixels.width_px(), at_first > 0};
    // In [1, last_px], for its rounding is far below the doubt.
    const double crossed_px = std::ceil(first / -right_);
    const double before = first + (crossed_px - 1) * right_, behind = first + crossed_px * right_;
    const bool certain = side(before, doubt) == at_first && side(behind, doubt) == at_last;
    return {certain ? static_cast<int32_t>(crossed_px) : -1, at_first > 0};
  }

 private:
  static constexpr double kDoubt = 0x1p-50;
  // 1 beyond the line, -1 before it, 0 where that is not certain.
  [[nodiscard]] static int side(double value, double doubt) {
    if (value >= doubt) return 1;
    return value <= -doubt ? -1 : 0;
  }
  [[nodiscard]] static double to_double(uint128 a) {
    return static_cast<double>(static_cast<int128>(a));
  }

  int32_t px_ = 0, row_ = 0;
  double start_ = 0, right_ = 0, down_ = 0;
};

}  // namespace selvage::mapper
