#include "mapper/kernel.h"

#include "mapper/vector_kernel.h"

namespace selvage::mapper {

// Widest first: measured (AMD EPYC), the fastest for meshes and perspective; the long affine spans
// of AVX2 are faster than those of AVX-512 there by a sixth.
inline constexpr selvage_kernel kByPreference[] = {SELVAGE_KERNEL_AVX512, SELVAGE_KERNEL_AVX2,
                                                   SELVAGE_KERNEL_SSE4, SELVAGE_KERNEL_NEON};

bool is_usable(selvage_kernel kernel) {
  return kernel == SELVAGE_KERNEL_FASTEST || kernel == SELVAGE_KERNEL_SCALAR ||
         vector_kernels(kernel, SELVAGE_FILTER_NEAREST) != nullptr;
}

const Kernels& kernels_for(selvage_kernel kernel, selvage_filter filter, const Surface& surface,
                           const Polygon& polygon) {
  if (kernel == SELVAGE_KERNEL_SCALAR || !fits_vectors(surface, polygon)) {
    return scalar_kernels(filter);
  }
  if (kernel != SELVAGE_KERNEL_FASTEST) return *vector_kernels(kernel, filter);
  const Kernels* fastest = nullptr;
  for (const selvage_kernel each : kByPreference) {
    if (fastest == nullptr) fastest = vector_kernels(each, filter);
  }
  return fastest != nullptr ? *fastest : scalar_kernels(filter);
}

}  // namespace selvage::mapper
