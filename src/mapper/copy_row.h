// The untransformed case: texels that are copied, a row of them at a time.
#pragma once

#include <cstdint>

#include "selvage.h"

namespace selvage::mapper {

// Writes width_px > 0 pixels from `pixels` on: the texels (s, t), (s + 1, t), ... addressed.
// |s|, |t| and width_px are below 2^17, so that no sum of them overflows.
void copy_row(const selvage_texture& texture, selvage_address address, int32_t s, int32_t t,
              int32_t width_px, char* pixels);

}  // namespace selvage::mapper
