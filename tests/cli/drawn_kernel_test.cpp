// The kernel that is told is the one that draws.
#include "cli/drawn_kernel.h"

#include <gtest/gtest.h>

#include <vector>

#include "cli/job.h"

namespace selvage::cli::test {
namespace {

using Vertices = std::vector<selvage_vertex>;

[[nodiscard]] std::string kernel_of(const Vertices& vertices, const selvage_options& options) {
  static uint8_t pixels[64 * 64 * 4], texels[8 * 8 * 4];
  const selvage_image target{pixels, 64, 64, 256, SELVAGE_RGBA8888};
  const selvage_texture texture{texels, 8, 8, 32, SELVAGE_RGBA8888, SELVAGE_LAYOUT_ROWS, nullptr};
  selvage_choice choice{};
  EXPECT_EQ(selvage_choose(&target, nullptr, vertices.data(), vertices.size(), &texture, &options,
                           &choice),
            SELVAGE_OK);
  return drawn_kernel(vertices, texture, options, choice.method);
}

[[nodiscard]] Vertices triangle(int32_t q, int32_t farthest_u) {
  return {{0, 0, 0, 0, 1000}, {16000, 0, farthest_u, 0, q}, {0, 16000, 0, 8 << 16, 1000}};
}

TEST(DrawnKernel, IsTheOneThatIsAskedFor) {
  for (selvage_kernel kernel = SELVAGE_KERNEL_SCALAR; kernel <= SELVAGE_KERNEL_NEON; ++kernel) {
    if (selvage_has_kernel(kernel) == 0) continue;
    for (const selvage_filter filter : {SELVAGE_FILTER_NEAREST, SELVAGE_FILTER_FOUR,
                                        SELVAGE_FILTER_BILINEAR, SELVAGE_FILTER_AREA}) {
      for (const int32_t q : {1000, 900}) {
        selvage_options options{};
        options.kernel = kernel;
        options.filter = filter;
        EXPECT_EQ(kernel_of(triangle(q, 8 << 16), options), kernel_name(kernel));
      }
    }
  }
}

TEST(DrawnKernel, IsOneOfThisMachineIfNoneIsAskedFor) {
  const std::string name = kernel_of(triangle(900, 8 << 16), {});
  bool is_here = false;
  for (selvage_kernel kernel = SELVAGE_KERNEL_SCALAR; kernel <= SELVAGE_KERNEL_NEON; ++kernel) {
    is_here = is_here || (selvage_has_kernel(kernel) != 0 && kernel_name(kernel) == name);
  }
  EXPECT_TRUE(is_here) << name;
}

// What vectors cannot hold is drawn by the scalar kernel, whatever is asked for.
TEST(DrawnKernel, IsScalarForTheLeastTexel) {
  Vertices far = triangle(900, 8 << 16);
  far[0].u = INT32_MIN;
  EXPECT_EQ(kernel_of(far, {}), "scalar");
}

TEST(DrawnKernel, IsNoneWhereNoneIs) {
  const Vertices copied = {{0, 0, 0, 0, 1}, {2048, 0, 8 << 16, 0, 1}, {0, 2048, 0, 8 << 16, 1}};
  EXPECT_EQ(kernel_of(copied, {}), "none");
  const Vertices nothing = {{-512, 0, 0, 0, 1}, {-256, 0, 0, 0, 1}, {-256, 512, 0, 0, 1}};
  EXPECT_EQ(kernel_of(nothing, {}), "none");
}

}  // namespace
}  // namespace selvage::cli::test
