// Number formats of the mapper, their bit budgets, and the integer helpers they need.
//
//   name         unit            bits   bound
//   x, y         1/256 px          24   |x| <= 2^23; a difference is below 2^24
//   height       1/256 px          24   of an edge, > 0
//   u, v         1/65536 texel     32   |u| <= 2^31
//   q            any               24   1 .. 2^24
//   edge x       x * height        48   |x| <= 2^23 * height
//   edge uq      u * q * height    80   |u q| <= 2^55
//   weight       x * height        48   distance to the far edge, >= 0
//   numerator    edge uq * weight  128  see kNumeratorBits
#pragma once

#include <cfloat>
#include <cstdint>
#include <limits>

// SELVAGE_OWN_INT128 is for trying ours where the compiler has its own; without vectors.
#if !defined(__SIZEOF_INT128__) || defined(SELVAGE_OWN_INT128)
#include "mapper/integer128.h"
#endif

namespace selvage::mapper {

// What the bounds of all that is computed in double take for granted.
static_assert(std::numeric_limits<double>::is_iec559 && FLT_EVAL_METHOD == 0,
              "each operation rounds once, to a double: 32-bit x86 wants -msse2 -mfpmath=sse");
#ifdef __FAST_MATH__
#error "Selvage's bounds hold for IEEE 754's arithmetic: compile it without -ffast-math and -Ofast"
#endif

#if !defined(__SIZEOF_INT128__) || defined(SELVAGE_OWN_INT128)
using int128 = Integer128<true>;
using uint128 = Integer128<false>;
#else
__extension__ typedef __int128 int128;
__extension__ typedef unsigned __int128 uint128;
#endif

inline constexpr int kPositionBits = 24;   // of a difference of two positions
inline constexpr int kTexelFraction = 16;  // u, v are 16.16
inline constexpr int kTexelBits = 31;      // |u| <= 2^31
inline constexpr int kQBits = 24;          // q <= 2^24
inline constexpr int kSubpixelBits = 8;
inline constexpr int32_t kSubpixels = 1 << kSubpixelBits;
inline constexpr int32_t kHalfPixel = kSubpixels / 2;

// An edge's uq is a mean of two u q, times the height. Along a span it is weighed by the distances
// to both edges, so that |numerator| <= max|u q| * height_left * height_right * width: not the
// bound of one product twice, for the two weights add up to the width.
inline constexpr int kEdgeBits = kTexelBits + kQBits + kPositionBits;
inline constexpr int kNumeratorBits = kEdgeBits + 2 * kPositionBits;
static_assert(kEdgeBits <= 79);
static_assert(kNumeratorBits <= 127, "a numerator fits a signed 128-bit integer");

// A weight is a distance, as the numerator of a fraction over both heights of which one cancels.
inline constexpr int kWeightBits = 2 * kPositionBits;
static_assert(kWeightBits + 1 < 64 && kQBits + kPositionBits < 64, "EdgePoint::x, q fit int64_t");

// From a pixel to the next, a numerator changes by two edge values times a height, 256 times over.
static_assert(kEdgeBits + kPositionBits + 1 + kSubpixelBits < 127);
static_assert(kQBits + 2 * kPositionBits + 1 + kSubpixelBits + kTexelFraction < 127);

// A denominator is q * height_left * height_right * width, in units of 1/65536 texel; times a texel
// column of at most 2^15 it is no longer than a numerator.
inline constexpr int kDenominatorBits = kQBits + 3 * kPositionBits + kTexelFraction;
static_assert(kDenominatorBits + (kTexelBits - kTexelFraction) <= 127);

// floor(a / b) for b > 0.
[[nodiscard]] constexpr int64_t floor_div(int64_t a, int64_t b) {
  const int64_t quotient = a / b;
  return quotient - (a % b < 0 ? 1 : 0);
}

// The row whose centre is the first at or below y, that is ceil((y - 128) / 256); likewise columns.
[[nodiscard]] constexpr int32_t first_centre_px(int32_t position_fx8) {
  return (position_fx8 + kHalfPixel - 1) >> kSubpixelBits;
}

[[nodiscard]] constexpr int32_t centre_fx8(int32_t px) { return px * kSubpixels + kHalfPixel; }

static_assert(first_centre_px(128) == 0 && first_centre_px(129) == 1 &&
              first_centre_px(-128) == -1);

}  // namespace selvage::mapper
