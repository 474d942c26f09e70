#include "reports/bench/kernels.h"

#include <array>
#include <cstddef>
#include <stdexcept>

namespace selvage::reports {

namespace {

std::vector<selvage_kernel> kernels_that(bool usable) {
  std::vector<selvage_kernel> kernels;
  for (selvage_kernel each = SELVAGE_KERNEL_SCALAR; each <= SELVAGE_KERNEL_NEON; ++each) {
    if ((selvage_has_kernel(each) != 0) == usable) kernels.push_back(each);
  }
  return kernels;
}

}  // namespace

std::string kernel_name(selvage_kernel kernel) {
  constexpr std::array kNames{"fastest", "scalar", "sse4", "avx2", "avx512", "neon"};
  return kNames.at(static_cast<size_t>(kernel));
}

std::vector<selvage_kernel> kernels_here() { return kernels_that(true); }
std::vector<selvage_kernel> kernels_elsewhere() { return kernels_that(false); }

std::vector<FastestKernel> fastest_kernels() {
  constexpr std::array kFilters{"nearest", "four", "bilinear", "area"};
  constexpr std::array kWorks{"large", "mesh", "perspective"};
  std::vector<std::max_align_t> scratch(SELVAGE_FASTEST_KERNEL_BYTES / sizeof(std::max_align_t));
  std::vector<FastestKernel> all;
  for (size_t filter = 0; filter < kFilters.size(); ++filter) {
    for (size_t work = 0; work < kWorks.size(); ++work) {
      FastestKernel one{kFilters[filter], kWorks[work], SELVAGE_KERNEL_FASTEST};
      const selvage_status status = selvage_fastest_kernel(
          static_cast<selvage_filter>(filter), SELVAGE_RGBA8888, static_cast<selvage_work>(work),
          scratch.data(), SELVAGE_FASTEST_KERNEL_BYTES, &one.kernel);
      if (status != SELVAGE_OK)
        throw std::runtime_error(std::string("selvage_fastest_kernel: ") +
                                 selvage_status_text(status));
      all.push_back(std::move(one));
    }
  }
  return all;
}

}  // namespace selvage::reports
