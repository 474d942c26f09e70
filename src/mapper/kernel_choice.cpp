#include "mapper/kernel_choice.h"

#include <algorithm>

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

const Kernels& kernels_for(const selvage_options& options, selvage_work work) {
  if (options.kernel != SELVAGE_KERNEL_FASTEST) return *kernels_of(options.kernel, options.filter);
  const Kernels* fastest = nullptr;
  (void)std::ranges::any_of(kernel_order(options.filter, work), [&](selvage_kernel each) {
    fastest = kernels_of(each, options.filter);
    return fastest != nullptr;
  });
  return *fastest;
}

const Kernels& kernels_for(const selvage_options& options, const selvage_texture& texture,
                           const Polygon& polygon) {
  if (!places_fit(texture) || !lanes_fit(polygon)) return scalar_kernels(options.filter);
  return kernels_for(options, work_of(polygon, options.tolerance));
}

}  // namespace selvage::mapper
