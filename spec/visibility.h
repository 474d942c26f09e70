// Hidden surfaces: which of several polygons shows at a pixel, by asking all of them.
//
// A polygon's nearness at a pixel is its q there, 1/w on a scale common to all, by the same map
// that u and v come from (spec/README.md, section 4). The greatest shows; among equals the first.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "spec/exact.h"

namespace selvage::spec {

using Polygons = std::vector<std::vector<selvage_vertex>>;

// q at the pixel's centre; empty if the pixel is not covered. The outline must be y-monotone.
[[nodiscard]] std::optional<Rational> nearness(std::span<const selvage_vertex> vertices,
                                               int32_t x_px, int32_t y_px);

// For each pixel of a picture, row by row: the index of the polygon that shows, if any covers it.
[[nodiscard]] std::vector<std::optional<size_t>> visible(const Polygons& polygons, int32_t width_px,
                                                         int32_t height_px);

}  // namespace selvage::spec
