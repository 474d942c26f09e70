// What is counted is drawn in one way, whichever is the faster on the machine that counts.
#include "mapper/vector/kernel.h"

namespace selvage::mapper {

bool are_gathers_fast() { return true; }

}  // namespace selvage::mapper
