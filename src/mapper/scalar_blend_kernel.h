// The kernels of all filters but nearest, for every machine.
#pragma once

#include "mapper/kernel.h"

namespace selvage::mapper {

extern const Kernels kFourScalar, kBilinearScalar, kAreaScalar;

}  // namespace selvage::mapper
