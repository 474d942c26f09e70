#include "mapper/kernel.h"

#include <algorithm>

#include "mapper/kernel_preference.h"
#include "mapper/vector_kernel.h"

namespace selvage::mapper {
namespace {

// NULL where the build or the machine has no such kernel.
[[nodiscard]] const Kernels* kernels_of(selvage_kernel kernel, selvage_filter filter) {
  return kernel == SELVAGE_KERNEL_SCALAR ? &scalar_kernels(filter) : vector_kernels(kernel, filter);
}

}  // namespace

bool is_usable(selvage_kernel kernel) {
  return kernel == SELVAGE_KERNEL_FASTEST || kernels_of(kernel, SELVAGE_FILTER_NEAREST) != nullptr;
}

const Kernels& kernels_for(const selvage_options& options, const Surface& surface,
                           const Polygon& polygon) {
  const selvage_filter filter = options.filter;
  if (!fits_vectors(surface, polygon)) return scalar_kernels(filter);
  if (options.kernel != SELVAGE_KERNEL_FASTEST) return *kernels_of(options.kernel, filter);
  const Kernels* fastest = nullptr;
  (void)std::ranges::any_of(kernel_order(filter, work_of(polygon, options.tolerance)),
                            [&](selvage_kernel each) {
                              fastest = kernels_of(each, filter);
                              return fastest != nullptr;
                            });
  return *fastest;
}

}  // namespace selvage::mapper
