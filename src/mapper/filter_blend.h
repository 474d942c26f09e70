// The texel stage of the filters over four texels: what is around a point, mixed in integers.
//
// Plain types only, so that a stage may be replaced by any other that writes the same bytes.
#pragma once

#include <cstdint>
#include <span>

#include "mapper/filter_point.h"
#include "selvage.h"

namespace selvage::mapper {

// Writes pixels.size() RGBA8888 pixels. `points` are of consecutive pixels of one span, so that u
// and v rise or fall all along; as many as pixels.
using BlendKernel = void (*)(std::span<const FilterPoint> points, const selvage_texture& texture,
                             selvage_address address, char* pixels);

void blend_four(std::span<const FilterPoint> points, const selvage_texture& texture,
                selvage_address address, char* pixels);
void blend_bilinear(std::span<const FilterPoint> points, const selvage_texture& texture,
                    selvage_address address, char* pixels);

}  // namespace selvage::mapper
