// A case over rows that are wide: where what is decided once a row, or a vector of pixels at a
// time, has something to say.
#pragma once

#include <cstdint>
#include <vector>

#include "spec/case.h"
#include "spec/law_tools.h"

namespace selvage::spec {

// Linearly from [least, greatest] of the values to [to_least, to_greatest].
void fit(std::vector<selvage_vertex>* vertices, int32_t selvage_vertex::*axis, int64_t to_least,
         int64_t to_greatest);

// From 160 to 400 px wide and 1 to 5 rows high, with milder depths.
[[nodiscard]] Case made_wide(const Case& c, Choices& choices);

}  // namespace selvage::spec
