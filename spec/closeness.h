// How near a case comes to the places where rounding decides: edges at sample points, coordinates
// at the borders of texels. Told by the case alone; no mapper is asked.
#pragma once

#include <cstdint>

#include "spec/case.h"

namespace selvage::spec {

// At a distance of 2^-n of a pixel or texel a place counts n^2 / kMostBits, n up to kMostBits; what
// is nearer than 2^-kTieBits counts as a tie, which rounding less often decides: n is kOfATie.
// Where the step from place to place is a whole number of 1/65536, so that fixed point walks
// without an error, it counts a quarter. Of each kind the kPlaces nearest are added up.
inline constexpr int32_t kPlaces = 16;
inline constexpr int32_t kMostBits = 32, kTieBits = 34, kOfATie = 16;

struct Closeness {
  int32_t edges = 0;   // where edges cross the rows of sample points, from the nearest such point
  int32_t texels = 0;  // u and v at sample points, from the next step of the texel shown

  friend bool operator==(const Closeness&, const Closeness&) = default;
};

// Of what a valid case draws within its clip; of any other it is nothing. Filters step where their
// weights or their box do. At most kMostLines rows and as many columns are looked at, evenly
// spread. Coordinates are double: near 32768 texels they tell so many bits and no more.
inline constexpr int32_t kMostLines = 64;
[[nodiscard]] Closeness closeness(const Case& c);

}  // namespace selvage::spec
