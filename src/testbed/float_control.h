// How this thread's floating-point numbers are rounded, which a call must leave as it was.
#pragma once

#include <fpu_control.h>

#include <cstdint>

namespace selvage::testbed {

struct FloatControl {
  fpu_control_t word = 0;  // of the only unit there is, or of the x87
  uint32_t vectors = 0;    // of SSE: rounding, flushing to zero, what traps

  friend bool operator==(const FloatControl&, const FloatControl&) = default;
};

inline constexpr uint32_t kSseFlags = 0x3F;  // what has happened; the other bits control

[[nodiscard]] inline FloatControl float_control() {
  FloatControl control;
  _FPU_GETCW(control.word);
#if defined(__SSE__)
  control.vectors = __builtin_ia32_stmxcsr() & ~kSseFlags;
#endif
  return control;
}

inline void set_float_control(FloatControl control) {
  _FPU_SETCW(control.word);
#if defined(__SSE__)
  __builtin_ia32_ldmxcsr(control.vectors | (__builtin_ia32_stmxcsr() & kSseFlags));
#endif
}

}  // namespace selvage::testbed
