// A corner of a polygon as tests by hand give it: in whole pixels and texels.
#pragma once

#include <cstdint>

#include "selvage.h"

namespace selvage::spec {

[[nodiscard]] inline selvage_vertex corner(int32_t x_px, int32_t y_px, int32_t u_texel,
                                           int32_t v_texel, int32_t q = 1) {
  return {x_px * SELVAGE_SUBPIXELS, y_px * SELVAGE_SUBPIXELS, u_texel * SELVAGE_SUBTEXELS,
          v_texel * SELVAGE_SUBTEXELS, q};
}

}  // namespace selvage::spec
