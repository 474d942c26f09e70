// Which kernels draw a polygon.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "mapper/kernel.h"
#include "mapper/kernel_preference.h"
#include "mapper/polygon.h"
#include "mapper/vector/kernel.h"
#include "selvage.h"

namespace selvage::mapper {

// NULL where the build or the machine has no such kernel.
[[nodiscard]] const Kernels* kernels_of(selvage_kernel kernel, selvage_filter filter);

// Whether this build and this machine have it.
[[nodiscard]] inline bool is_usable(selvage_kernel kernel) {
  return kernel == SELVAGE_KERNEL_FASTEST || kernels_of(kernel, SELVAGE_FILTER_NEAREST) != nullptr;
}

// Those of options.kernel, which this machine can run.
[[nodiscard]] const Kernels& kernels_for(const selvage_options& options, selvage_work work);

// The same, or the scalar ones for what a vector kernel cannot hold.
[[nodiscard]] const Kernels& kernels_for(const selvage_options& options,
                                         const selvage_texture& texture, const Polygon& polygon);

// The same for many polygons of one texture.
class KernelChoice {
 public:
  KernelChoice(const selvage_options& options, const selvage_texture& texture)
      : scalar_(&scalar_kernels(options.filter)), tolerance_(options.tolerance) {
    const bool fits = places_fit(texture);
    for (size_t work = 0; work < kWorks; ++work) {
      by_work_[work] = fits ? &kernels_for(options, static_cast<selvage_work>(work)) : scalar_;
    }
  }

  [[nodiscard]] const Kernels& of(const Polygon& polygon) const {
    if (!lanes_fit(polygon)) return *scalar_;
    return of_work(work_of(polygon, tolerance_));
  }
  // Of polygons that lanes fit.
  [[nodiscard]] const Kernels& of_work(selvage_work work) const {
    return *by_work_[static_cast<size_t>(work)];
  }

 private:
  const Kernels* scalar_;
  std::array<const Kernels*, kWorks> by_work_{};
  int32_t tolerance_;
};

}  // namespace selvage::mapper
