// Kernels side by side: which there are, and what one draws.
#pragma once

#include <gtest/gtest.h>

#include <vector>

#include "mapper/kernel.h"
#include "mapper/kernel_choice.h"
#include "mapper/vector/kernel.h"
#include "spec/canvas.h"
#include "spec/case.h"
#include "spec/texture_memory.h"

namespace selvage::mapper {

// Those that this machine can run; the others are reported as untested.
[[nodiscard]] inline std::vector<selvage_kernel> usable_kernels() {
  std::vector<selvage_kernel> usable;
  for (selvage_kernel each = SELVAGE_KERNEL_SCALAR; each <= SELVAGE_KERNEL_NEON; ++each) {
    if (is_usable(each)) usable.push_back(each);
  }
  return usable;
}

// Those of them that step the same rows as the scalar one; the others step fewer.
[[nodiscard]] inline std::vector<selvage_kernel> stepping_kernels() {
  std::vector<selvage_kernel> stepping = usable_kernels();
  std::erase_if(stepping, [](selvage_kernel each) {
    const Kernels* const vector = vector_kernels(each, SELVAGE_FILTER_NEAREST);
    return vector != nullptr && vector->stepping.least_row_px != kUsualStepping.least_row_px;
  });
  return stepping;
}

// A side of the textures that tests give to one row.
inline constexpr int32_t kRowTexture_texel = 64;

// What kernels that are compared draw from and onto.
[[nodiscard]] inline spec::TextureMemory texture_of(const spec::Case& c) {
  return spec::TextureMemory(
      spec::built_in(), c,
      [](spec::Texel at) {
        const auto s = static_cast<uint32_t>(at.s), t = static_cast<uint32_t>(at.t);
        return (s * 40503U + t * 7919U) * 2654435761U;
      },
      0xEE);
}
[[nodiscard]] inline spec::Canvas target_of(const spec::Case& c) {
  return spec::Canvas(c.format, c.target_width_px, c.target_height_px, c.padding_px, c.flip_target,
                      0x11);
}

[[nodiscard]] inline spec::Canvas drawing_of(const spec::Case& c, selvage_kernel kernel,
                                             int32_t tolerance = 0) {
  const spec::TextureMemory texture = texture_of(c);
  spec::Canvas target = target_of(c);
  const selvage_image image = target.image();
  const selvage_texture view = texture.view();
  const selvage_options options{c.profile, c.filter, c.address, tolerance, kernel};
  const selvage_status status = selvage_draw(&image, c.has_clip ? &c.clip : nullptr,
                                             c.vertices.data(), c.vertices.size(), &view, &options);
  EXPECT_NE(status, SELVAGE_ERROR_KERNEL);
  return target;
}

// Fatal where some kernel draws something else than the scalar one.
inline void expect_drawn_alike(const spec::Case& c, uint64_t seed) {
  const spec::Canvas scalar = drawing_of(c, SELVAGE_KERNEL_SCALAR);
  for (const selvage_kernel kernel : usable_kernels()) {
    ASSERT_TRUE(drawing_of(c, kernel) == scalar) << "kernel " << kernel << ", seed " << seed << "\n"
                                                 << spec::print(c);
  }
}

}  // namespace selvage::mapper
