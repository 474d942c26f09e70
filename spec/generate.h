// Cases out of seeds, and simpler cases out of cases.
#pragma once

#include <cstdint>
#include <vector>

#include "spec/case.h"

namespace selvage::spec {

// The case of a seed: the same on every machine. Biased to the hard places: ties, boundaries,
// slivers, degenerates, far-off vertices, extreme scales, the ends of every range.
[[nodiscard]] Case generate(uint64_t seed);

// Cases that are each simpler than c in one way, the greatest simplification first: fewer vertices,
// smaller images, rounder numbers. Repeated descent ends, for each lowers spec/complexity.h.
[[nodiscard]] std::vector<Case> simpler(const Case& c);

}  // namespace selvage::spec
