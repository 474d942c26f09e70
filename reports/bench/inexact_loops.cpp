// The inexact loops of every SIMD target: Highway includes this file again for each.
#include "reports/bench/inexact_loops.h"

// Its checks, which debug builds switch on, would call into its library.
#define HWY_IS_DEBUG_BUILD 0
#define HWY_DISABLED_TARGETS \
  (HWY_SSSE3 | HWY_AVX3_DL | HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128)
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "reports/bench/inexact_loops.cpp"
#include <hwy/foreach_target.h>
// after foreach_target.h, which chooses the target
#include <hwy/highway.h>

#if HWY_TARGET != HWY_SCALAR && HWY_TARGET != HWY_EMU128
#include "reports/bench/inexact_rows-inl.h"

namespace selvage::reports::HWY_NAMESPACE {

void add_loops(std::vector<InexactLoop>& loops, const std::string& target) {
  if constexpr (kHasMasks) {
    loops.push_back({target + "-window", draw_by_windows});
    loops.push_back({target + "-gather", draw_polygon<Gathers>});
  }
  loops.push_back({target + "-load", draw_polygon<Loads>});
}

}  // namespace selvage::reports::HWY_NAMESPACE
#endif

#if HWY_ONCE
#include "selvage.h"

namespace selvage::reports {

std::vector<InexactLoop> inexact_loops() {
  std::vector<InexactLoop> loops;
#if HWY_TARGETS & HWY_AVX3
  if (selvage_has_kernel(SELVAGE_KERNEL_AVX512) != 0) N_AVX3::add_loops(loops, "avx512");
#endif
#if HWY_TARGETS & HWY_AVX2
  if (selvage_has_kernel(SELVAGE_KERNEL_AVX2) != 0) N_AVX2::add_loops(loops, "avx2");
#endif
#if HWY_TARGETS & HWY_SSE4
  if (selvage_has_kernel(SELVAGE_KERNEL_SSE4) != 0) N_SSE4::add_loops(loops, "sse4");
#endif
#if HWY_TARGETS & HWY_NEON
  if (selvage_has_kernel(SELVAGE_KERNEL_NEON) != 0) N_NEON::add_loops(loops, "neon");
#endif
  return loops;
}

}  // namespace selvage::reports
#endif
