// The texture of law FILTER: colours out of Case::choice, all bytes alike or as far apart as they
// go.
#pragma once

#include "spec/case.h"
#include "spec/filter.h"

namespace selvage::spec {

[[nodiscard]] TexelAt filter_texture(const Case& c);

}  // namespace selvage::spec
