// A build without vectors: SELVAGE_SIMD=OFF, no Highway, or no integer of 128 bits.
#include "mapper/vector/kernel.h"

namespace selvage::mapper {

const Kernels* vector_kernels(selvage_kernel /*kernel*/, selvage_filter /*filter*/) {
  return nullptr;
}

const Kernels* first_vector_kernels(std::span<const selvage_kernel> /*order*/,
                                    selvage_filter /*filter*/) {
  return nullptr;
}

}  // namespace selvage::mapper
