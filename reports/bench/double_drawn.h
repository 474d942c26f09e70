// Pixels that two polygons of a workload draw, seen from outside.
//
// A picture does not tell how often a pixel was written, and a mapper under measurement is asked
// for pictures only. So the polygons are sorted into classes such that those of one class are at
// least kApart_px apart, each class is drawn alone on an empty target, and a pixel counts that two
// classes or more have drawn. Two polygons of one class could only meet in pixels that far off one
// of them; the count of extra pixels would show a mapper that does this along an outline.
#pragma once

#include <cstdint>
#include <vector>

#include "reports/bench/subject.h"

namespace selvage::reports {

inline constexpr int32_t kApart_px = 2;

// The polygons of each class. The boxes round two polygons of a class are kApart_px apart at least.
[[nodiscard]] std::vector<Workload> apart(const Workload& load);

// On these rows. The target is overwritten.
[[nodiscard]] uint64_t count_double(const Subject& subject, const std::vector<Workload>& classes,
                                    const Texture& texture, const std::vector<int32_t>& rows_px,
                                    Target& target);

}  // namespace selvage::reports
