// The tables of the vector kernels: Highway includes this file again for each SIMD target.
#include "mapper/vector/kernel.h"

#include "mapper/vector/targets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "mapper/vector/kernel.cpp"
#include <hwy/foreach_target.h>
// after foreach_target.h, which chooses the target
#include <hwy/highway.h>

#if HWY_TARGET != HWY_SCALAR && HWY_TARGET != HWY_EMU128
#include "mapper/vector/entries-inl.h"

namespace selvage::mapper::HWY_NAMESPACE {

#if SELVAGE_DRAWS_SMALL
constexpr auto kDrawSmall = &draw_small;
constexpr SmallLimits kSmallLimits = kSmall;
#else
constexpr decltype(&draw_small) kDrawSmall = nullptr;
constexpr SmallLimits kSmallLimits = {};
#endif

constexpr Kernels kNearest = {
    .find_spans = find_spans,
    .find_lanes = find_lanes,
    .find_ruled_lanes = find_ruled_lanes,
    .draw_affine = draw_affine,
    .draw_projective = draw_projective,
    .draw_ruled = draw_ruled,
    .pays_near_plane = pays_near_plane,
    .draw_near_plane = draw_near_plane,
    .draw_small = kDrawSmall,
    .small = kSmallLimits,
    .draw_stepped = draw_stepped,
    .stepping = HWY_TARGET == HWY_AVX3 ? kWideStepping : kUsualStepping,
};
constexpr Kernels kFour = {find_spans, find_lanes, find_ruled_lanes, draw_four_affine,
                           draw_four_projective};
constexpr Kernels kBilinear = {find_spans, find_lanes, find_ruled_lanes, draw_bilinear_affine,
                               draw_bilinear_projective};
constexpr Kernels kArea = {
    .find_spans = find_spans,
    .find_lanes = find_lanes,
    .find_ruled_lanes = find_ruled_lanes,
    .draw_affine = draw_bilinear_affine,
    .draw_projective = draw_bilinear_projective,
    .draw_boxes_affine = draw_boxes_affine,
    .draw_boxes_projective = draw_boxes_projective,
    .draw_boxes = draw_boxes,
};

const Kernels& kernels(selvage_filter filter) {
  switch (filter) {
    case SELVAGE_FILTER_FOUR:
      return kFour;
    case SELVAGE_FILTER_BILINEAR:
      return kBilinear;
    case SELVAGE_FILTER_AREA:
      return kArea;
    default:
      return kNearest;
  }
}

}  // namespace selvage::mapper::HWY_NAMESPACE
#endif

#if HWY_ONCE
namespace selvage::mapper {
namespace {

// Of the instructions that Highway compiles each target for, those that machines may lack.
#if HWY_TARGETS & HWY_SSE4
[[nodiscard]] bool has_sse4() {
  return __builtin_cpu_supports("sse4.2") && __builtin_cpu_supports("pclmul") &&
         __builtin_cpu_supports("aes");
}
#endif
#if HWY_TARGETS & HWY_AVX2
[[nodiscard]] bool has_avx2() {
  return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") &&
         __builtin_cpu_supports("bmi2") && __builtin_cpu_supports("f16c");
}
#endif
#if HWY_TARGETS & HWY_AVX3
[[nodiscard]] bool has_avx512() {
  return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl") &&
         __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512bw") &&
         __builtin_cpu_supports("bmi2");
}
#endif

// Every call looks for the fastest: in one piece, without a call for each that it tries.
[[nodiscard]] inline const Kernels* table_of([[maybe_unused]] selvage_kernel kernel,
                                             [[maybe_unused]] selvage_filter filter) {
#if HWY_TARGETS & HWY_SSE4
  if (kernel == SELVAGE_KERNEL_SSE4 && has_sse4()) return &N_SSE4::kernels(filter);
#endif
#if HWY_TARGETS & HWY_AVX2
  if (kernel == SELVAGE_KERNEL_AVX2 && has_avx2()) return &N_AVX2::kernels(filter);
#endif
#if HWY_TARGETS & HWY_AVX3
  if (kernel == SELVAGE_KERNEL_AVX512 && has_avx512()) return &N_AVX3::kernels(filter);
#endif
#if HWY_TARGETS & HWY_NEON
  if (kernel == SELVAGE_KERNEL_NEON) return &N_NEON::kernels(filter);
#endif
  return nullptr;
}

}  // namespace

bool were_gathers_faster() {
#if HWY_TARGETS & HWY_AVX3
  return __builtin_cpu_is("amd") != 0;
#else
  return false;
#endif
}

[[gnu::weak]] bool are_gathers_fast() { return were_gathers_faster(); }

const Kernels* vector_kernels(selvage_kernel kernel, selvage_filter filter) {
  return table_of(kernel, filter);
}

const Kernels* first_vector_kernels(std::span<const selvage_kernel> order, selvage_filter filter) {
  for (const selvage_kernel each : order) {
    const Kernels* const kernels = table_of(each, filter);
    if (kernels != nullptr || each == SELVAGE_KERNEL_SCALAR) return kernels;
  }
  return nullptr;
}

}  // namespace selvage::mapper
#endif
