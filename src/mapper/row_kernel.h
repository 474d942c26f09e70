// The row kernel: the inner loop, from a span's map to texels to pixels.
//
// Plain types only, so that a kernel may be replaced by any other that writes the same bytes.
#pragma once

#include "mapper/span.h"
#include "selvage.h"

namespace selvage::mapper {

// Writes the pixels of a span that is not empty.
//
// row      the first byte of the target's row; pixel `px` is at row + px * bytes per pixel
// texture  has passed its checks and shares no byte with the row
using RowKernel = void (*)(const SpanMap& map, const Span& span, const selvage_texture& texture,
                           selvage_address address, void* row);

// The kernel for a format, nearest texels, and a polygon whose q are all equal (affine) or not.
[[nodiscard]] RowKernel row_kernel(selvage_format format, bool affine);

}  // namespace selvage::mapper
