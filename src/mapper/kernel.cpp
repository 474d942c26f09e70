#include "mapper/kernel.h"

#include "mapper/kernel_preference.h"
#include "mapper/vector_kernel.h"

namespace selvage::mapper {

bool is_usable(selvage_kernel kernel) {
  return kernel == SELVAGE_KERNEL_FASTEST || kernel == SELVAGE_KERNEL_SCALAR ||
         vector_kernels(kernel, SELVAGE_FILTER_NEAREST) != nullptr;
}

const Kernels& kernels_for(const selvage_options& options, const Surface& surface,
                           const Polygon& polygon) {
  const selvage_filter filter = options.filter;
  if (options.kernel == SELVAGE_KERNEL_SCALAR || !fits_vectors(surface, polygon)) {
    return scalar_kernels(filter);
  }
  if (options.kernel != SELVAGE_KERNEL_FASTEST) return *vector_kernels(options.kernel, filter);
  for (const selvage_kernel kernel : kernel_order(filter, work_of(polygon, options.tolerance))) {
    if (const Kernels* const vector = vector_kernels(kernel, filter)) return *vector;
  }
  return scalar_kernels(filter);
}

}  // namespace selvage::mapper
