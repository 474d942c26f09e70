// The mapper's kernels on this machine, and which is the fastest at what.
#pragma once

#include <string>
#include <vector>

#include "selvage.h"

namespace selvage::reports {

[[nodiscard]] std::string kernel_name(selvage_kernel kernel);

// Those that this build has and this machine can run; the others.
[[nodiscard]] std::vector<selvage_kernel> kernels_here();
[[nodiscard]] std::vector<selvage_kernel> kernels_elsewhere();

// An answer of selvage_fastest_kernel for RGBA8888.
struct FastestKernel {
  std::string filter, work;
  selvage_kernel kernel;
};

// For each filter that has kernels and each kind of work: some milliseconds each.
[[nodiscard]] std::vector<FastestKernel> fastest_kernels();

}  // namespace selvage::reports
