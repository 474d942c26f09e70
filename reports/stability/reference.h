// A scene and what the exact model shows of it: computed once, shared by all contenders.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "spec/case.h"
#include "spec/exact.h"

namespace selvage::stability {

struct Reference {
  spec::Case scene;  // in RGBA8888, the format whose texels all tell their place
  std::vector<std::optional<spec::Texel>> texels;  // row by row; empty where nothing is covered
  uint64_t covered_px = 0;
  bool shows_address = false;  // some texels lie beyond the texture before they are addressed
};

// The scene must be of the exact profile; an outline that is not y-monotone covers nothing.
[[nodiscard]] Reference reference(spec::Case scene);

}  // namespace selvage::stability
