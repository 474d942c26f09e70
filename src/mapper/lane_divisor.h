// Floors of many quotients by one divisor, in 2^-32 texel, at the price of one floating-point
// division.
#pragma once

#include <cstdint>

#include "mapper/lanes.h"
#include "mapper/number.h"
#include "mapper/to_double.h"

namespace selvage::mapper {

// |n / d| < 2^16 texels: a coordinate is below 2^15, and so is its change between two pixels of a
// span below 2^16. The estimate's relative error is below 7 * 2^-53 (two conversions, one division,
// one product), so it is off by less than 2^48 * 7 * 2^-53 < kEstimateError_fx32, and its floor by
// at most one. The remainder, exact modulo 2^128 and known to lie in [-2d, 2d), tells which way.
class LaneDivisor {
 public:
  explicit LaneDivisor(int128 d)
      : divisor_(static_cast<uint128>(d)), reciprocal_fx32_(kLaneUnit / to_double(d)) {}

  // floor(2^32 n / d)
  [[nodiscard]] int64_t floor_fx32(int128 n) const {
    const double estimate = to_double(n) * reciprocal_fx32_;
    int64_t quotient = static_cast<int64_t>(estimate) - (estimate < 0 ? 1 : 0);
    const auto remainder = static_cast<int128>((static_cast<uint128>(n) << kLaneFraction) -
                                               static_cast<uint128>(int128{quotient}) * divisor_);
    if (remainder < 0) {
      --quotient;
    } else if (remainder >= static_cast<int128>(divisor_)) {
      ++quotient;
    }
    return quotient;
  }

 private:
  static constexpr double kLaneUnit = 4294967296.0;  // 2^kLaneFraction

  uint128 divisor_;
  double reciprocal_fx32_;
};

static_assert(kDenominatorBits + 2 < 127, "a remainder fits int128");

}  // namespace selvage::mapper
