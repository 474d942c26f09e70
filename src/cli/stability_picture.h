// A drawing of a hard scene beside the exact model's.
#pragma once

#include "cli/raster.h"
#include "reports/stability/contender.h"
#include "reports/stability/reference.h"

namespace selvage::cli {

// As comparison_picture.h has it, framed where the texel error is largest. In the difference a
// wrong texel is the brighter the further off it is, from dark red to pale yellow; what is missing
// is blue, what is extra is green.
[[nodiscard]] Raster stability_picture(const stability::Contender& contender,
                                       const stability::Reference& model);

}  // namespace selvage::cli
