// Wide rows in no plane of which one coordinate lies next to a boundary between texels all along,
// on either side of it or across, while the other crosses many texels: every kernel draws what the
// scalar one draws.
#include <gtest/gtest.h>

#include <cstdint>
#include <cstdlib>
#include <utility>
#include <vector>

#include "spec/random.h"
#include "spec/vertex_units.h"
#include "tests/kernel_support.h"

namespace selvage::mapper {
namespace {

using spec::kPixel_fx8;
using spec::kTexel_fx16;

// A coordinate over a quad: at the centre of its first pixel, by a pixel to the right and by one
// down; and by how much each corner is off.
struct QuadCoordinate {
  int32_t start_fx16, right_fx16, down_fx16;
  int32_t off_fx16[4];
};

// Next to a boundary in each row, or from one side of it to the other.
[[nodiscard]] QuadCoordinate along_boundaries(spec::Random& random) {
  QuadCoordinate along{
      random.in(-2, 30) * kTexel_fx16, 0, random.pick({0, 1, -1, 2}) * kTexel_fx16, {}};
  for (int32_t& off : along.off_fx16) off = random.in(-3, 4);
  return along;
}

[[nodiscard]] QuadCoordinate across_texels(spec::Random& random) {
  const int32_t right_fx16 = random.percent(70) ? kTexel_fx16 / random.pick({1, 2, 3, 4, 6, 16})
                                                : random.in(kTexel_fx16 / 64, kTexel_fx16 * 2);
  QuadCoordinate across{random.in(-4, 40) * kTexel_fx16 / random.pick({1, 4}),
                        random.percent(70) ? right_fx16 : -right_fx16,
                        random.pick({0, 0, kTexel_fx16 / 4, random.in(-9999, 9999)}),
                        {}};
  across.off_fx16[random.in(0, 4)] = random.in(-1, 2);
  return across;
}

[[nodiscard]] spec::Case any_rows(uint64_t seed) {
  spec::Random random(seed);
  spec::Case c;
  c.target_width_px = random.in(70, 320);
  c.target_height_px = random.in(17, 65);
  c.texture_width_texel = random.pick({16, 24, 32, 64});
  c.texture_height_texel = random.pick({16, 24, 32, 64});
  c.address = random.percent(50) ? SELVAGE_ADDRESS_CLAMP : SELVAGE_ADDRESS_WRAP;
  c.format = random.pick({SELVAGE_INDEX8, SELVAGE_RGB565, SELVAGE_RGBA8888});
  QuadCoordinate u = across_texels(random), v = along_boundaries(random);
  // With corners far off denominators exceed 64 bits.
  const bool far = std::abs(u.right_fx16) <= kTexel_fx16 && random.percent(70);
  const int32_t right_px = far ? random.in(24000, 32000) : c.target_width_px + random.in(-4, 40);
  const int32_t right = right_px * kPixel_fx8;
  for (const size_t corner : {1U, 2U}) v.off_fx16[corner] *= right_px / c.target_width_px;
  if (random.percent(50)) std::swap(u, v);
  const int32_t low = c.target_height_px * kPixel_fx8 + random.in(0, 300);
  const int32_t slant = random.percent(50) ? random.in(-3000, 3000) : 0;
  c.vertices = {
      {0, 0, 0, 0, 1}, {right, 0, 0, 0, 1}, {right + slant, low, 0, 0, 1}, {slant, low, 0, 0, 1}};
  const int32_t q = random.percent(50) ? 1 : SELVAGE_Q_MAX;
  for (size_t i = 0; i < c.vertices.size(); ++i) {
    selvage_vertex& vertex = c.vertices[i];
    const auto at = [&](const QuadCoordinate& coordinate) {
      const int64_t right_fx8 = vertex.x - kPixel_fx8 / 2, down_fx8 = vertex.y - kPixel_fx8 / 2;
      return coordinate.start_fx16 + coordinate.off_fx16[i] +
             static_cast<int32_t>(
                 (right_fx8 * coordinate.right_fx16 + down_fx8 * coordinate.down_fx16) /
                 kPixel_fx8);
    };
    vertex.u = at(u);
    vertex.v = at(v);
    vertex.q = q;
  }
  return c;
}

// A block of seeds.
class RowsOfTies : public testing::TestWithParam<uint64_t> {};

TEST_P(RowsOfTies, EveryKernelDrawsWhatTheScalarOneDraws) {
  constexpr uint64_t kSeeds = 200;
  for (uint64_t seed = GetParam() * kSeeds; seed < (GetParam() + 1) * kSeeds; ++seed) {
    const spec::Case c = any_rows(seed);
    const spec::Canvas scalar = drawing_of(c, SELVAGE_KERNEL_SCALAR);
    for (const selvage_kernel kernel : usable_kernels()) {
      ASSERT_TRUE(drawing_of(c, kernel) == scalar)
          << "kernel " << kernel << ", seed " << seed << "\n"
          << spec::print(c);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Block, RowsOfTies, testing::Range(uint64_t{0}, uint64_t{4}));

}  // namespace
}  // namespace selvage::mapper
