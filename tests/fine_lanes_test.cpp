// Lanes of 8.24 in the rows of one window: they are as low as the steps from the first column and
// row make them, which ties find out.
#include <gtest/gtest.h>

#include <cstdint>

#include "spec/random.h"
#include "spec/vertex_units.h"
#include "tests/kernel_support.h"

namespace selvage::mapper {
namespace {

using spec::kPixel_fx8;
using spec::kTexel_fx16;

// A parallelogram that leans by `lean_px` a row, 1 more than a multiple of 3: u is a twelfth of
// what x is right of its left edge, so that every twelfth sample of a row lies on a boundary. A
// step of 2^24 / 12 loses a third of a unit, and there are up to some thousand of them.
[[nodiscard]] spec::Case any_leaning(spec::Random& random, int32_t lean_px) {
  constexpr int32_t kWidth_texel = 5, kWidth_px = 12 * kWidth_texel;
  spec::Case c;
  c.format = random.pick({SELVAGE_INDEX8, SELVAGE_RGB565, SELVAGE_RGBA8888});
  c.texture_width_texel = c.texture_height_texel = 16;
  c.target_height_px = random.in(2, 64);
  const int32_t leant_px = lean_px * c.target_height_px;
  c.target_width_px = kWidth_px + (leant_px < 0 ? -leant_px : leant_px);
  const int32_t top_px = leant_px < 0 ? -leant_px : 0, bottom_px = top_px + leant_px;
  const int32_t left_fx16 = kTexel_fx16 + (lean_px - 1) * kTexel_fx16 / 24;
  const int32_t u_fx16 = (left_fx16 & (kTexel_fx16 - 1)) + random.in(1, 8) * kTexel_fx16;
  const int32_t v_fx16 = random.in(0, 16 * kTexel_fx16);
  const auto corner = [&](int32_t x_px, int32_t y_px, int32_t right_texel) {
    return selvage_vertex{x_px * kPixel_fx8, y_px * kPixel_fx8, u_fx16 + right_texel * kTexel_fx16,
                          v_fx16, 1};
  };
  c.vertices = {corner(top_px, 0, 0), corner(top_px + kWidth_px, 0, kWidth_texel),
                corner(bottom_px + kWidth_px, c.target_height_px, kWidth_texel),
                corner(bottom_px, c.target_height_px, 0)};
  return c;
}

TEST(FineLanes, OfRowsThatLeanFarShowTheTexelsOfTies) {
  for (uint64_t seed = 1; seed <= 200; ++seed) {
    spec::Random random(seed);
    const int32_t lean_px = 1 + 3 * random.in(-20, 21);
    const spec::Case c = any_leaning(random, lean_px);
    const spec::Canvas right = drawing_of(c, SELVAGE_KERNEL_SCALAR);
    for (const selvage_kernel kernel : usable_kernels()) {
      ASSERT_TRUE(drawing_of(c, kernel) == right)
          << "kernel " << kernel << ", seed " << seed << ", " << lean_px << " px a row\n"
          << spec::print(c);
    }
  }
}

}  // namespace
}  // namespace selvage::mapper
