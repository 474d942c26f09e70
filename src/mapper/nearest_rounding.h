// How doubles are rounded, and which of their exceptions trap, is a mode of the processor's, and
// whoever calls may have chosen another one: for interval arithmetic, say, or to find a mistake.
#pragma once

#include <cfenv>

namespace selvage::mapper {

// Whether doubles are rounded to the nearest, and, on x86, nothing traps: lanes that no pixel is
// taken from may divide by 0.
[[nodiscard]] inline bool rounds_to_nearest() {
#ifdef __SSE2__
  constexpr unsigned kRounding = 0x6000, kMasked = 0x1F80;
  return (__builtin_ia32_stmxcsr() & (kRounding | kMasked)) == kMasked;
#else
  // Read at run time: a compiler would do the sums itself.
  static const volatile double kBelowHalfUnit = 0x1p-60;
  const double tiny = kBelowHalfUnit;
  return 1 + tiny == 1 && 1 - tiny == 1;
#endif
}

// The bounds take rounding to the nearest for granted: while one of these lives, that is the mode.
#ifdef FE_TONEAREST
class NearestRounding {
 public:
  NearestRounding() : is_callers_(rounds_to_nearest()) {
    if (is_callers_) return;
    std::feholdexcept(&callers_);
    std::fesetround(FE_TONEAREST);
  }
  ~NearestRounding() {
    if (!is_callers_) std::fesetenv(&callers_);
  }
  NearestRounding(const NearestRounding&) = delete;
  NearestRounding& operator=(const NearestRounding&) = delete;

 private:
  bool is_callers_;      // the caller rounds so, too
  std::fenv_t callers_;  // if not: how the caller does
};
#else  // a C library without modes, for bare metal
class NearestRounding {
 public:
  NearestRounding() {}
};
#endif

}  // namespace selvage::mapper
