// The texels of spans that are stepped within a tolerance: Highway includes this file again for
// each SIMD target.
#include "mapper/vector/targets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "mapper/vector/stepped.cpp"
#include <hwy/foreach_target.h>
// after foreach_target.h, which chooses the target
#include <hwy/highway.h>

#if HWY_TARGET != HWY_SCALAR && HWY_TARGET != HWY_EMU128
#include "mapper/vector/stepped_kernel-inl.h"
#endif
