// The kernels of the filters over four texels, for every machine.
#pragma once

#include "mapper/kernel.h"

namespace selvage::mapper {

extern const Kernels kFourScalar, kBilinearScalar;

}  // namespace selvage::mapper
