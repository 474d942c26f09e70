// The second half of drawing many polygons: bands, drawn side by side. A band is drawn as a clip
// rectangle would have it drawn, so that by law CLIP no band changes a pixel, whatever their number
// and whoever draws them.
#pragma once

#include <cstdint>

#include "many/band_index.h"
#include "many/bands.h"
#include "many/prepare.h"

namespace selvage::many {

// Draws request.prepared, whose polygons reach these rows; `index` is of them.
void draw_in_bands(const Request& request, const BandIndex& index, Rows reach, int32_t workers);

}  // namespace selvage::many
