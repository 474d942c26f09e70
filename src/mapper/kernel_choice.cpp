#include "mapper/kernel_choice.h"

namespace selvage::mapper {

const Kernels* kernels_of(selvage_kernel kernel, selvage_filter filter) {
  return kernel == SELVAGE_KERNEL_SCALAR ? &scalar_kernels(filter) : vector_kernels(kernel, filter);
}

const Kernels& kernels_for(const selvage_options& options, selvage_work work) {
  if (options.kernel != SELVAGE_KERNEL_FASTEST) return *kernels_of(options.kernel, options.filter);
  const Kernels* const fastest =
      first_vector_kernels(kernel_order(options.filter, work), options.filter);
  return fastest != nullptr ? *fastest : scalar_kernels(options.filter);
}

const Kernels& kernels_for(const selvage_options& options, const selvage_texture& texture,
                           const Polygon& polygon) {
  if (!places_fit(texture) || !lanes_fit(polygon)) return scalar_kernels(options.filter);
  return kernels_for(options, work_of(polygon, options.tolerance));
}

}  // namespace selvage::mapper
