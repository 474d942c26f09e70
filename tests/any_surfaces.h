// What textures and targets are like, for tests that choose their sizes.
#pragma once

#include "spec/case.h"
#include "spec/random.h"

namespace selvage::mapper {

// Of any format and address mode, either stored bottom row first or not.
[[nodiscard]] inline spec::Case any_surfaces(spec::Random& random) {
  spec::Case c;
  c.format = random.pick({SELVAGE_INDEX8, SELVAGE_RGB565, SELVAGE_RGBA8888});
  c.address = random.percent(50) ? SELVAGE_ADDRESS_CLAMP : SELVAGE_ADDRESS_WRAP;
  c.flip_target = random.percent(20);
  c.flip_texture = random.percent(20);
  return c;
}

}  // namespace selvage::mapper
