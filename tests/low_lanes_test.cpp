// Affine lanes as low as their margin allows, and margins up to the widest: wherever a kernel takes
// a lane for less wrong than it may be, it draws another texel.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <optional>

#include "mapper/plane.h"
#include "mapper/polygon.h"
#include "mapper/span_batch.h"
#include "spec/random.h"
#include "spec/vertex_units.h"
#include "tests/kernel_support.h"

namespace selvage::mapper {
namespace {

using spec::kPixel_fx8;
using spec::kTexel_fx16;

// A triangle over most of a target whose rows have many vectors. Its windows have any number of
// rows, one of them, and half as many columns as there are lanes.
[[nodiscard]] spec::Case any_affine_triangle(spec::Random& random) {
  spec::Case c;
  c.format = random.pick({SELVAGE_INDEX8, SELVAGE_RGB565, SELVAGE_RGBA8888});
  c.address = random.percent(50) ? SELVAGE_ADDRESS_CLAMP : SELVAGE_ADDRESS_WRAP;
  c.target_width_px = random.in(40, 700);
  c.target_height_px = random.in(2, 20);
  c.texture_width_texel = c.texture_height_texel = random.pick({64, 100, 512});
  const auto fx16 = [&](int32_t texels) { return random.in(0, texels * kTexel_fx16); };
  const int32_t along = std::min(c.target_width_px, c.texture_width_texel);
  const int32_t u_texel = random.pick({along, along / 2, along / 4});
  const int32_t v_texel = random.pick({0, u_texel / 16, u_texel / 4, u_texel / 2, u_texel});
  const int32_t right_fx8 = c.target_width_px * kPixel_fx8,
                bottom_fx8 = c.target_height_px * kPixel_fx8;
  c.vertices = {{0, 0, fx16(u_texel), fx16(v_texel), 1},
                {right_fx8, random.in(0, bottom_fx8), fx16(u_texel), fx16(v_texel), 1},
                {random.in(0, right_fx8), bottom_fx8, fx16(u_texel), fx16(v_texel), 1}};
  return c;
}

// Lanes that are lower than they were, by as much as the margin is wider or less.
[[nodiscard]] AffineField lowered(spec::Random& random, AffineField field) {
  const auto least = static_cast<int64_t>(field.margin_fx32);
  const int64_t wider =
      std::min(random.pick({int64_t{0}, int64_t{1} << 16, int64_t{1} << 18, int64_t{1} << 20,
                            int64_t{1} << 24, kWidestMargin_fx32}),
               kWidestMargin_fx32 - least);
  field.margin_fx32 = static_cast<uint32_t>(least + wider);
  field.start.u_fx32 -= wider * random.in(0, 17) / 16;
  field.start.v_fx32 -= wider * random.in(0, 17) / 16;
  return field;
}

[[nodiscard]] spec::Canvas drawing_from_field(const Kernels& kernels, const spec::Case& c,
                                              const Polygon& polygon, const Plane& plane,
                                              const AffineField& field) {
  const spec::TextureMemory texture = texture_of(c);
  spec::Canvas target = target_of(c);
  const Surface surface{target.image(), texture.view(), c.address};
  BatchWalk walk(polygon, part_of(polygon, {0, 0, c.target_width_px, c.target_height_px}),
                 kernels.find_spans);
  SpanBatch batch;
  while (walk.next(&batch)) {
    kernels.draw_affine({batch, field, polygon.texels, ExactMap(plane)}, surface);
  }
  return target;
}

// A block of seeds.
class LowLanes : public testing::TestWithParam<uint64_t> {
 protected:
  static constexpr uint64_t kSeeds = 200;
};

TEST_P(LowLanes, EveryKernelDrawsTheRightTexels) {
  int drawn = 0;
  for (uint64_t seed = GetParam() * kSeeds + 1; seed <= (GetParam() + 1) * kSeeds; ++seed) {
    spec::Random random(seed);
    const spec::Case c = any_affine_triangle(random);
    Polygon polygon;
    if (examine(c.vertices, &polygon) != SELVAGE_OK) continue;
    const selvage_rect part = part_of(polygon, {0, 0, c.target_width_px, c.target_height_px});
    if (is_empty(part)) continue;
    const std::optional<Plane> plane = Plane::of(polygon, part);
    if (!plane) continue;
    ++drawn;
    const AffineField field = lowered(random, plane->lanes());
    const spec::Canvas right = drawing_of(c, SELVAGE_KERNEL_SCALAR);
    for (const selvage_kernel kernel : usable_kernels()) {
      const Kernels& kernels = kernel == SELVAGE_KERNEL_SCALAR
                                   ? scalar_kernels(SELVAGE_FILTER_NEAREST)
                                   : *vector_kernels(kernel, SELVAGE_FILTER_NEAREST);
      ASSERT_TRUE(drawing_from_field(kernels, c, polygon, *plane, field) == right)
          << "kernel " << kernel << ", seed " << seed << ", margin " << field.margin_fx32 << "\n"
          << spec::print(c);
    }
  }
  EXPECT_GT(drawn, 100);
}

INSTANTIATE_TEST_SUITE_P(Block, LowLanes, testing::Range(uint64_t{0}, uint64_t{5}));

}  // namespace
}  // namespace selvage::mapper
