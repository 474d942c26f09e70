// The row kernel: the inner loop, from lanes to texels to pixels.
//
// Plain types only, so that a kernel may be replaced by any other that writes the same bytes.
#pragma once

#include "mapper/exact_texel.h"
#include "mapper/lanes.h"
#include "mapper/span.h"
#include "selvage.h"

namespace selvage::mapper {

// Writes the pixels of a span that is not empty, nearest texels.
//
// lanes    of this span; `exact` decides where they do not
// row      the first byte of the target's row; pixel `px` is at row + px * bytes per pixel
// texture  has passed its checks and shares no byte with the row
template <class Lanes>
using RowKernel = void (*)(const Lanes& lanes, const ExactTexel& exact, const Span& span,
                           const selvage_texture& texture, selvage_address address, void* row);

[[nodiscard]] RowKernel<AffineLanes> affine_row_kernel(selvage_format format);
[[nodiscard]] RowKernel<ProjectiveLanes> projective_row_kernel(selvage_format format);

}  // namespace selvage::mapper
