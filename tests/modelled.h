// What each kernel draws, against the model.
#pragma once

#include <gtest/gtest.h>

#include "spec/model.h"
#include "spec/picture.h"
#include "spec/subject.h"
#include "tests/kernel_support.h"

namespace selvage::mapper {

[[nodiscard]] inline spec::Subject drawing_by(selvage_kernel kernel) {
  spec::Subject subject = spec::built_in();
  subject.draw = [kernel](const selvage_image* target, const selvage_rect* clip,
                          const selvage_vertex* vertices, size_t count,
                          const selvage_texture* texture, const selvage_options* options) {
    selvage_options by_kernel = *options;
    by_kernel.kernel = kernel;
    return selvage_draw(target, clip, vertices, count, texture, &by_kernel);
  };
  return subject;
}

inline void expect_drawn_as_modelled(const spec::Case& c, const spec::TexelAt& texel_at) {
  const spec::Picture model = spec::expected(c, texel_at);
  for (const selvage_kernel kernel : usable_kernels()) {
    const spec::Picture drawn = spec::draw(drawing_by(kernel), c, texel_at);
    ASSERT_EQ(drawn.status, SELVAGE_OK);
    ASSERT_EQ(drawn.memory_fault, "");
    for (int32_t y = 0; y < c.target_height_px; ++y) {
      for (int32_t x = 0; x < c.target_width_px; ++x) {
        ASSERT_EQ(drawn.at(x, y), model.at(x, y))
            << "kernel " << kernel << ", pixel " << x << ", " << y << "\n"
            << spec::print(c);
      }
    }
  }
}

}  // namespace selvage::mapper
