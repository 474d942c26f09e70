// How complicated a case is, so that simplifying has an end.
#pragma once

#include <array>
#include <cstdint>

#include "spec/case.h"

namespace selvage::spec {

// Compared from the first number on. Numbers are at least 0 and their count is fixed, so no
// descending sequence is endless. In order:
//   the vertices
//   width + height of the target
//   width + height of the texture
//   options that are not at their simplest: a clip, padding, flips, wrap, a layout, a format but
//   RGBA8888 fraction bits of x, y, u, v: places after the binary point, over all vertices
//   magnitudes of x, y, u, v, q - 1, padding, the clip's sides and the choice, added up
using Complexity = std::array<uint64_t, 6>;

[[nodiscard]] Complexity complexity(const Case& c);

}  // namespace selvage::spec
