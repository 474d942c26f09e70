// Drawing with a historic profile, told in whole pixels and texels.
#pragma once

#include <gtest/gtest.h>

#include <vector>

#include "spec/model.h"
#include "spec/picture.h"
#include "spec/profiles.h"

namespace selvage::historic::test {

struct Corner {
  int32_t x_px, y_px, u_texel, v_texel;
};

// A case of a profile over a texture and a target of the sizes given.
[[nodiscard]] inline spec::Case case_of(selvage_profile profile, const std::vector<Corner>& corners,
                                        int32_t target_px = 40, int32_t texture_texel = 64) {
  spec::Case c;
  c.profile = profile;
  c.target_width_px = c.target_height_px = target_px;
  c.texture_width_texel = c.texture_height_texel = texture_texel;
  for (const auto& [x, y, u, v] : corners) {
    c.vertices.push_back({x * SELVAGE_SUBPIXELS, y * SELVAGE_SUBPIXELS, u * SELVAGE_SUBTEXELS,
                          v * SELVAGE_SUBTEXELS, 1});
  }
  return c;
}

[[nodiscard]] inline spec::Picture drawn(const spec::Case& c) {
  spec::Picture picture = spec::draw(spec::built_in(), c);
  EXPECT_EQ(picture.memory_fault, "");
  return picture;
}

[[nodiscard]] inline uint64_t drawn_px(const spec::Picture& picture) {
  uint64_t count = 0;
  for (const auto& pixel : picture.pixels) count += pixel.has_value() ? 1 : 0;
  return count;
}

// The texel that a pixel shows; (-1, -1) where nothing was drawn.
[[nodiscard]] inline spec::Texel texel_at(const spec::Picture& picture, int32_t x_px,
                                          int32_t y_px) {
  const auto& pixel = picture.at(x_px, y_px);
  if (!pixel) return {-1, -1};
  return {static_cast<int32_t>(*pixel & 0xFFFF), static_cast<int32_t>(*pixel >> 16)};
}

}  // namespace selvage::historic::test
