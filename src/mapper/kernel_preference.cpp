#include "mapper/kernel_preference.h"

namespace selvage::mapper {
namespace {

inline constexpr selvage_kernel kScalar = SELVAGE_KERNEL_SCALAR, kSse4 = SELVAGE_KERNEL_SSE4,
                                kAvx2 = SELVAGE_KERNEL_AVX2, kAvx512 = SELVAGE_KERNEL_AVX512,
                                kNeon = SELVAGE_KERNEL_NEON;

// Measured on one machine (AMD EPYC, family 25, model 17); NEON was run in emulation only.
inline constexpr KernelOrder kWidestFirst = {kAvx512, kAvx2, kSse4, kNeon, kScalar};
// By a tenth faster there: small triangles by area.
inline constexpr KernelOrder kAvx2First = {kAvx2, kAvx512, kSse4, kNeon, kScalar};

// By selvage_work: large, mesh, perspective.
inline constexpr KernelOrder kUsual[kWorks] = {kWidestFirst, kWidestFirst, kWidestFirst};
inline constexpr KernelOrder kByArea[kWorks] = {kWidestFirst, kAvx2First, kWidestFirst};

}  // namespace

const KernelOrder& kernel_order(selvage_filter filter, selvage_work work) {
  return (filter == SELVAGE_FILTER_AREA ? kByArea : kUsual)[work];
}

}  // namespace selvage::mapper
