// The mapper's integers of 128 bits as GMP's, and back: what it does to them, done by another hand.
#pragma once

#include <gmpxx.h>

#include <array>
#include <cstdint>

#include "mapper/number.h"

namespace selvage::mapper {

[[nodiscard]] inline mpz_class whole(uint128 n) {
  const std::array parts{static_cast<uint64_t>(n), static_cast<uint64_t>(n >> 64)};
  mpz_class result;
  mpz_import(result.get_mpz_t(), parts.size(), -1, sizeof parts[0], 0, 0, parts.data());
  return result;
}
[[nodiscard]] inline mpz_class whole(int128 n) {
  const auto bits = static_cast<uint128>(n);
  return n < 0 ? mpz_class(-whole(uint128{0} - bits)) : whole(bits);
}

// Modulo 2^128.
[[nodiscard]] inline uint128 bits_of(const mpz_class& n) {
  mpz_class low;
  mpz_fdiv_r_2exp(low.get_mpz_t(), n.get_mpz_t(), 128);
  std::array<uint64_t, 2> parts{};
  mpz_export(parts.data(), nullptr, -1, sizeof parts[0], 0, 0, low.get_mpz_t());
  return uint128{parts[1]} << 64 | parts[0];
}

// The floor of n / d; d > 0.
[[nodiscard]] inline int64_t floor_of(int128 n, int128 d) {
  mpz_class quotient;
  mpz_fdiv_q(quotient.get_mpz_t(), whole(n).get_mpz_t(), whole(d).get_mpz_t());
  return static_cast<int64_t>(bits_of(quotient));
}

// What is left of n, in [0, d).
[[nodiscard]] inline int128 remainder_of(int128 n, int128 d) {
  mpz_class remainder;
  mpz_fdiv_r(remainder.get_mpz_t(), whole(n).get_mpz_t(), whole(d).get_mpz_t());
  return static_cast<int128>(bits_of(remainder));
}

}  // namespace selvage::mapper
