// What tests of near-ties share: a picture by each kernel, of a texture without two equal texels in
// sight.
#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <optional>
#include <vector>

#include "mapper/kernel_choice.h"
#include "spec/canvas.h"

namespace selvage::mapper {

inline constexpr int32_t kNearTiesTexture_texel = 32;

struct NearTiesTarget {
  int32_t width_px = 300, height_px = 6;
  selvage_format format = SELVAGE_RGBA8888;
  selvage_filter filter = SELVAGE_FILTER_NEAREST;
  std::optional<selvage_rect> clip = std::nullopt;
};

[[nodiscard]] inline spec::Canvas near_ties_drawing(const std::vector<selvage_vertex>& polygon,
                                                    selvage_kernel kernel,
                                                    const NearTiesTarget& on) {
  spec::Canvas texels(on.format, kNearTiesTexture_texel, kNearTiesTexture_texel, 0, false, 0);
  for (int32_t t = 0; t < kNearTiesTexture_texel; ++t) {
    for (int32_t s = 0; s < kNearTiesTexture_texel; ++s) {
      texels.set_pixel(s, t, static_cast<uint32_t>(s * 40503 + t * 7919) * 2654435761U);
    }
  }
  spec::Canvas target(on.format, on.width_px, on.height_px, 0, false, 0x11);
  const selvage_image image = target.image();
  const selvage_texture texture = texels.texture();
  const selvage_options options{SELVAGE_PROFILE_EXACT, on.filter, SELVAGE_ADDRESS_WRAP, 0, kernel};
  EXPECT_EQ(selvage_draw(&image, on.clip ? &*on.clip : nullptr, polygon.data(), polygon.size(),
                         &texture, &options),
            SELVAGE_OK);
  return target;
}

// Fatal where some kernel draws something else than the scalar one.
inline void expect_near_ties_alike(const std::vector<selvage_vertex>& polygon,
                                   const NearTiesTarget& on, uint64_t seed) {
  const spec::Canvas scalar = near_ties_drawing(polygon, SELVAGE_KERNEL_SCALAR, on);
  for (selvage_kernel kernel = SELVAGE_KERNEL_SCALAR; kernel <= SELVAGE_KERNEL_NEON; ++kernel) {
    if (!is_usable(kernel)) continue;
    ASSERT_TRUE(near_ties_drawing(polygon, kernel, on) == scalar)
        << "kernel " << kernel << ", seed " << seed;
  }
}

}  // namespace selvage::mapper
