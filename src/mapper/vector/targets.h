// Highway's settings for what is compiled once for each SIMD target. Included before Highway.
#pragma once

// Its checks, which debug and sanitizer builds switch on, would call into its library.
#define HWY_IS_DEBUG_BUILD 0
// CMake's option SELVAGE_KERNELS.
#ifndef SELVAGE_LEFT_OUT
#define SELVAGE_LEFT_OUT 0
#endif
// What lies between SSE4, AVX2 and AVX-512 has nothing that these kernels use.
#define HWY_DISABLED_TARGETS \
  (HWY_SSSE3 | HWY_AVX3_DL | HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128 | SELVAGE_LEFT_OUT)

// Whether a target draws small polygons: with four doubles or more to the vector, fused products.
#define SELVAGE_DRAWS_SMALL (HWY_TARGET == HWY_AVX2 || HWY_TARGET == HWY_AVX3)
