#include "cli/drawn_kernel.h"

#include "cli/job.h"
#include "mapper/kernel.h"
#include "mapper/kernel_choice.h"
#include "mapper/polygon.h"
#include "mapper/vector/kernel.h"

namespace selvage::cli {

std::string drawn_kernel(std::span<const selvage_vertex> vertices, const selvage_texture& texture,
                         const selvage_options& options, selvage_method method) {
  const bool has_kernel = method != SELVAGE_METHOD_NONE && method != SELVAGE_METHOD_COPY &&
                          method != SELVAGE_METHOD_HISTORIC;
  mapper::Polygon polygon;
  if (!has_kernel || mapper::examine(vertices, &polygon) != SELVAGE_OK) return "none";
  const mapper::Kernels* const drawn = &mapper::kernels_for(options, texture, polygon);
  for (selvage_kernel kernel = SELVAGE_KERNEL_SSE4; kernel <= SELVAGE_KERNEL_NEON; ++kernel) {
    if (mapper::vector_kernels(kernel, options.filter) == drawn) {
      return std::string(kernel_name(kernel));
    }
  }
  return std::string(kernel_name(SELVAGE_KERNEL_SCALAR));
}

}  // namespace selvage::cli
