// What is left to draw, judged by some of the polygons: drawing goes on while it is judged.
#pragma once

#include "many/band_work.h"
#include "many/bands.h"
#include "many/hand_over.h"
#include "many/prepare.h"

namespace selvage::many {

// The bands that a prepared polygon reaches.
[[nodiscard]] BandRange bands_of(const Request& request, const Bands& bands, size_t polygon);

// What drawing a prepared polygon costs in each band that it reaches, about.
[[nodiscard]] double cost_of_band_px(const Request& request, const Bands& bands, size_t polygon);

// What a part costs in each of its bands, about; of its first polygon, what is within `of_first`.
[[nodiscard]] BandWork work_left(const Request& request, const Bands& bands, const Part& part,
                                 BandRange of_first);

}  // namespace selvage::many
