// The picture of the project's front page: the Earth as a globe, as waves, and the mesh of both.
#pragma once

#include "cli/raster.h"
#include "reports/gallery/pictures.h"

namespace selvage::reports {

[[nodiscard]] cli::Raster draw_banner(const Pictures& pictures);

}  // namespace selvage::reports
