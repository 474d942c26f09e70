// Not what the library answers: texels are fetched as on the other kind of processor.
#include "mapper/vector/kernel.h"

namespace selvage::mapper {

bool are_gathers_fast() { return !were_gathers_faster(); }

}  // namespace selvage::mapper
