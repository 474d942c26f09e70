// Rows in perspective by windows: u and v change by up to a texel a pixel at the far end, and by
// more beyond it, where no pixel is.
#include <gtest/gtest.h>

#include <cstdint>

#include "spec/random.h"
#include "tests/kernel_support.h"
#include "tests/rounded.h"

namespace selvage::mapper {
namespace {

// A rectangle whose q falls to the right, or rises, on a texture that is wider than a window.
[[nodiscard]] spec::Case any_receding_rectangle(uint64_t seed) {
  spec::Random random(seed);
  spec::Case c;
  c.format = random.pick({SELVAGE_INDEX8, SELVAGE_RGB565, SELVAGE_RGBA8888});
  c.address = random.percent(50) ? SELVAGE_ADDRESS_CLAMP : SELVAGE_ADDRESS_WRAP;
  c.texture_width_texel = random.pick({16, 33, 64, 128});
  c.texture_height_texel = random.pick({10, 33, 64});
  c.target_width_px = random.in(17, 130);
  c.target_height_px = random.in(1, 12);
  const int32_t width_px = c.target_width_px, height_px = c.target_height_px;
  const double turn = random.in(0, 33) / 1000.0;  // of the least q, a pixel
  const double growth = 1 + turn * width_px;
  const int32_t least_q = random.in(1, 1 << 16) * 64, most_q = rounded(least_q * growth);
  const bool falls = random.percent(70);
  // By so many texels from end to end, so that the change is up to a texel at the steeper end.
  const auto change = [&](double steepest_texel) {
    return width_px / growth * steepest_texel * random.in(-1000, 1001) / 1000;
  };
  const double u_change = change(1), v_change = change(random.percent(50) ? 0.6 : 0.1);
  const double u = random.in(-20, 100) + random.in(0, 5) / 4.0;
  const double v = random.in(-20, 50) + random.in(0, 5) / 4.0, down = random.in(-4, 5) / 4.0;
  for (const int corner : {0, 1, 2, 3}) {
    const bool right = corner == 1 || corner == 2, below = corner >= 2;
    const double v_down = below ? down * height_px : 0;
    c.vertices.push_back({right ? width_px * 256 : 0, below ? height_px * 256 : 0,
                          rounded((u + (right ? u_change : 0)) * 65536),
                          rounded((v + (right ? v_change : 0) + v_down) * 65536),
                          right == falls ? least_q : most_q});
  }
  if (random.percent(50)) c.vertices.pop_back();  // a triangle always has a plane
  return c;
}

TEST(PieceWindows, EveryKernelDrawsWhatTheScalarOneDraws) {
  for (uint64_t seed = 1; seed <= 3000; ++seed) {
    const spec::Case c = any_receding_rectangle(seed);
    const spec::Canvas scalar = drawing_of(c, SELVAGE_KERNEL_SCALAR);
    for (const selvage_kernel kernel : usable_kernels()) {
      ASSERT_TRUE(drawing_of(c, kernel) == scalar)
          << "kernel " << kernel << ", seed " << seed << "\n"
          << spec::print(c);
    }
  }
}

}  // namespace
}  // namespace selvage::mapper
