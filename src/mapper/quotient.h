// Quotients of integers as a whole part and a remainder: n / d = whole + rest / d.
#pragma once

#include <cstdint>

#include "mapper/number.h"

namespace selvage::mapper {

// rest < d, a divisor that fits 64 bits.
struct Quotient {
  int32_t whole;
  uint64_t rest;

  friend bool operator==(const Quotient&, const Quotient&) = default;
};

// n / d, where its floor is `low` or the next number; n modulo 2^128.
[[nodiscard]] constexpr Quotient quotient_from(uint128 n, uint64_t d, int32_t low) {
  const uint128 rest = n - static_cast<uint128>(int128{low}) * d;
  return rest < d ? Quotient{low, static_cast<uint64_t>(rest)}
                  : Quotient{low + 1, static_cast<uint64_t>(rest - d)};
}

// The sum of remainders may leave 64 bits.
[[nodiscard]] constexpr Quotient sum(const Quotient& a, const Quotient& b, uint64_t d) {
  const uint64_t most = d - 1 - b.rest;
  if (a.rest > most) return {a.whole + b.whole + 1, a.rest - most - 1};
  return {a.whole + b.whole, a.rest + b.rest};
}

}  // namespace selvage::mapper
