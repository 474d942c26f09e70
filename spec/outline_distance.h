// How far a point lies from an outline: in x or in y, whichever is more. An outline whose points
// are all moved by less passes the point on the same side.
#pragma once

#include <cstdint>
#include <span>

#include "spec/exact.h"
#include "spec/geometry.h"

namespace selvage::spec {

// In pixels, of an outline of at least one vertex.
[[nodiscard]] Rational outline_distance_px(Point p, std::span<const selvage_vertex> outline);

// The same within 2^-35 px, of distances below 1 px, and much faster.
[[nodiscard]] double about_outline_distance_px(Point p, std::span<const selvage_vertex> outline);

// Whether it is at most reach_fx16, in 1/65536 px, which is at most 1 px.
[[nodiscard]] bool is_near_outline(Point p, std::span<const selvage_vertex> outline,
                                   int32_t reach_fx16);

}  // namespace selvage::spec
