#include "mapper/boundary.h"

#include <cmath>

#include "mapper/number.h"

namespace selvage::mapper {
namespace {

constexpr double kDoubt = 0x1p-50;

[[nodiscard]] double to_double(uint128 a) { return static_cast<double>(static_cast<int128>(a)); }

// 1 beyond the line, -1 before it, 0 where that is not certain.
[[nodiscard]] int side(double value, double doubt) {
  if (value >= doubt) return 1;
  return value <= -doubt ? -1 : 0;
}

}  // namespace

Boundary::Boundary(const ExactMap& map, ExactLine ExactRow::*coordinate, int bits, int32_t whole,
                   int32_t px, int32_t row)
    : px_(px), row_(row) {
  const auto k = static_cast<uint128>(int128{whole});
  const auto [here, below] = map.rows_from(px, row);
  const ExactLine n = here.*coordinate, d = here.finer_d(bits);
  const uint128 start = n.start - k * d.start;
  start_ = to_double(start);
  right_ = to_double(n.step - k * d.step);
  down_ = to_double((below.*coordinate).start - k * below.finer_d(bits).start - start);
}

Boundary::Sides Boundary::sides_of(const Span& pixels) const {
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

}  // namespace selvage::mapper
