// Unsigned integers of 256 bits, as far as footprints need them: products, sums, comparisons.
#pragma once

#include <compare>
#include <cstdint>

#include "mapper/number.h"

namespace selvage::mapper {

struct Wide {
  uint128 high = 0, low = 0;

  friend bool operator==(const Wide&, const Wide&) = default;
  friend std::strong_ordering operator<=>(const Wide& a, const Wide& b) {
    const auto order = [](uint128 x, uint128 y) {
      return x < y   ? std::strong_ordering::less
             : x > y ? std::strong_ordering::greater
                     : std::strong_ordering::equal;
    };
    return a.high != b.high ? order(a.high, b.high) : order(a.low, b.low);
  }
  // Modulo 2^256.
  friend Wide operator+(const Wide& a, const Wide& b) {
    const uint128 sum = a.low + b.low;
    return {a.high + b.high + (sum < a.low ? 1 : 0), sum};
  }
  friend Wide operator-(const Wide& a, const Wide& b) {
    return {a.high - b.high - (a.low < b.low ? 1 : 0), a.low - b.low};
  }
};

// By halves of 64 bits, as on paper.
[[nodiscard]] constexpr Wide product(uint128 a, uint128 b) {
  constexpr int kHalf = 64;
  const uint128 mask = ~uint64_t{0};
  const uint128 lowest = (a & mask) * (b & mask);
  const uint128 cross = (a >> kHalf) * (b & mask) + (lowest >> kHalf);
  const uint128 middle = (a & mask) * (b >> kHalf) + (cross & mask);
  return {(a >> kHalf) * (b >> kHalf) + (cross >> kHalf) + (middle >> kHalf),
          (middle << kHalf) | (lowest & mask)};
}

[[nodiscard]] constexpr uint128 magnitude(int128 a) {
  return a < 0 ? uint128{0} - static_cast<uint128>(a) : static_cast<uint128>(a);
}

// |a b - c d|, where both products are below 2^255.
[[nodiscard]] inline Wide distance(int128 a, int128 b, int128 c, int128 d) {
  const Wide first = product(magnitude(a), magnitude(b));
  const Wide second = product(magnitude(c), magnitude(d));
  if (((a < 0) != (b < 0)) != ((c < 0) != (d < 0))) return first + second;
  return first < second ? second - first : first - second;
}

}  // namespace selvage::mapper
