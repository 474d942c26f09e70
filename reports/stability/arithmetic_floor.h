// From floating point to texels and pixels.
#pragma once

#include <cstdint>

namespace selvage::stability {

// The greatest integer not above the value, which is held within 2^30 of 0 first; for no number
// (0/0 where a mapper's q vanishes) the least of these. No library call: without SSE 4.1 that is
// what std::floor is.
template <class Real>
[[nodiscard]] int32_t floor_index(Real value) {
  constexpr Real most = 1 << 30;
  Real held = value > -most ? value : -most;
  held = held < most ? held : most;
  const auto whole = static_cast<int32_t>(held);
  return whole - (static_cast<Real>(whole) > held ? 1 : 0);
}

}  // namespace selvage::stability
