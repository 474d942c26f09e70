// Integers of 128 bits as doubles.
#pragma once

#include <cstdint>

#include "mapper/number.h"

namespace selvage::mapper {

// What that is off by, in units of 2^-53 of the number.
inline constexpr double kConversionRoundings = 2.5;

// Three parts, each exact, in two sums that round; cheaper by far than what compilers call to round
// once. Where the first sum rounds, the last part is below 2^-53 of it.
[[nodiscard]] inline double to_double(int128 n) {
  constexpr int kPartBits = 52;
  constexpr int64_t kPart = (int64_t{1} << kPartBits) - 1;
  const auto low = static_cast<int64_t>(n) & kPart;
  const auto middle = static_cast<int64_t>(n >> kPartBits) & kPart;
  const auto high = static_cast<int64_t>(n >> (2 * kPartBits));
  return (static_cast<double>(high) * 0x1p52 + static_cast<double>(middle)) * 0x1p52 +
         static_cast<double>(low);
}

[[nodiscard]] inline double to_double(int64_t n) { return static_cast<double>(n); }

}  // namespace selvage::mapper
