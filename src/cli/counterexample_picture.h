// A violation to look at: drawn | expected | difference, enlarged.
#pragma once

#include "cli/comparison_picture.h"
#include "cli/raster.h"
#include "spec/drawings.h"
#include "spec/laws.h"
#include "spec/subject.h"

namespace selvage::cli {

// As comparison_picture.h has it: what differs is red, the blamed pixel framed. Where another
// drawing told what is allowed, that one is what was expected, else the model's. What was drawn is
// looked up in `drawings`, if there are some, and drawn by the subject else. Laws PART and PINWHEEL
// draw several tiles: a pixel that one of them draws is blue, one that two draw yellow, others
// white; tiles that run the other way round are taken off.
[[nodiscard]] PictureComparison counterexample(const spec::Subject& subject,
                                               const spec::Violation& violation,
                                               const spec::Drawings* drawings = nullptr);
[[nodiscard]] Raster counterexample_picture(const spec::Subject& subject,
                                            const spec::Violation& violation,
                                            const spec::Drawings* drawings = nullptr);

}  // namespace selvage::cli
