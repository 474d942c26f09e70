// The choices as a false-colour picture.
#pragma once

#include "cli/raster.h"
#include "reports/scenes/choices.h"
#include "reports/scenes/exact_view.h"

namespace selvage::reports {

// Each pixel in the colour of what it was drawn by, lighter and darker with the picture; the
// borders of faces are dark. What no face shows at stays as it is. Below the picture is a key.
[[nodiscard]] cli::Raster overlay(const cli::Raster& picture, const ExactView& exact,
                                  const RowChoices& choices);

}  // namespace selvage::reports
