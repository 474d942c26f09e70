// A violation to look at: drawn | expected | difference, enlarged.
#pragma once

#include "cli/raster.h"
#include "spec/laws.h"
#include "spec/subject.h"

namespace selvage::cli {

// Texel (s, t) is coloured by its place, red growing with s and green with t; a value that no texel
// has is magenta; what was not drawn is a grey chequerboard. In the difference, what differs is
// red over a dim copy of what was expected. A white frame marks the blamed pixel. Of a large
// target only the surroundings of that pixel are shown.
[[nodiscard]] Raster counterexample_picture(const spec::Subject& subject,
                                            const spec::Violation& violation);

}  // namespace selvage::cli
