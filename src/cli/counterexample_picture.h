// A violation to look at: drawn | expected | difference, enlarged.
#pragma once

#include "cli/raster.h"
#include "spec/laws.h"
#include "spec/subject.h"

namespace selvage::cli {

// As comparison_picture.h has it: what differs is red, the blamed pixel framed.
[[nodiscard]] Raster counterexample_picture(const spec::Subject& subject,
                                            const spec::Violation& violation);

}  // namespace selvage::cli
