// Rows wider than any vector: every kernel draws what the scalar one draws, in perspective too,
// within a tolerance, through the filters, from every layout, at near-ties all along a row.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include "spec/random.h"
#include "spec/vertex_units.h"
#include "tests/kernel_support.h"

namespace selvage::mapper {
namespace {

using spec::kPixel_fx8;
using spec::kTexel_fx16;

struct WideCase {
  spec::Case c;
  int32_t tolerance = 0;
};

[[nodiscard]] int32_t any_q(spec::Random& random, int kind) {
  if (kind < 30) return 1;
  if (kind < 60) return random.in(100, 200);
  if (kind < 80) return random.in(1, 20);
  return random.percent(50) ? random.in(1, 4) : random.in(1, int64_t{SELVAGE_Q_MAX} + 1);
}

// Under one turned and scaled map, or with v whole all along, each a hair off or not.
void set_coordinates(spec::Random& random, spec::Case* c) {
  static constexpr double kScales[] = {1, 1, 0.5, 0.25, 1.0 / 3, 2, 0.2, 1.0 / 16, 1.0 / 4096, 7};
  static constexpr double kAngles[] = {0, 0, 45, 90, 180, 225, 270};
  const double degrees = random.percent(50) ? random.pick(kAngles) : random.in(0, 360000) / 1000.0;
  const double scale = random.percent(60) ? random.pick(kScales) : random.in(1, 2000) / 1000.0;
  const double angle = degrees * std::numbers::pi / 180;
  const double cos = std::cos(angle) * scale, sin = std::sin(angle) * scale;
  const double u_texel = random.in(-20, c->texture_width_texel + 20) + random.in(0, 5) / 4.0;
  const double v_texel = random.in(-20, c->texture_height_texel + 20) + random.in(0, 5) / 4.0;
  const bool level = random.percent(25);
  const int off_percent = random.pick({0, 0, 20, 60}), q_kind = random.in(0, 100);
  for (selvage_vertex& vertex : c->vertices) {
    const double x_px = vertex.x / 256.0, y_px = vertex.y / 256.0;
    const auto fx16 = [&](double texel) {
      const double most = 32000, least = -most;
      const auto near =
          static_cast<int32_t>(std::lround(std::clamp(texel, least, most) * kTexel_fx16));
      return near + (random.percent(off_percent) ? random.in(-1, 2) : 0);
    };
    vertex.u = fx16(u_texel + x_px * cos - y_px * sin);
    vertex.v = fx16(level ? std::round(v_texel) : v_texel + x_px * sin + y_px * cos);
    vertex.q = any_q(random, q_kind);
  }
}

[[nodiscard]] WideCase any_wide_case(uint64_t seed) {
  static constexpr selvage_format kFormats[] = {SELVAGE_INDEX8, SELVAGE_RGB565, SELVAGE_RGBA8888};
  static constexpr int32_t kSizes[] = {1, 2, 7, 8, 9, 15, 16, 17, 24, 32, 33, 64, 100, 256};
  spec::Random random(seed);
  WideCase wide;
  spec::Case& c = wide.c;
  const int kind = random.in(0, 100);
  c.target_width_px = kind < 10 ? random.in(1000, 1400) : random.in(20, 200);
  if (kind >= 90) c.target_width_px = random.in(62, 68);  // about the widest drawn by strips
  c.target_height_px = kind >= 95 ? random.in(60, 140) : random.in(1, 7);
  c.texture_width_texel = random.pick(kSizes);
  c.texture_height_texel = random.pick(kSizes);
  c.address = random.percent(50) ? SELVAGE_ADDRESS_CLAMP : SELVAGE_ADDRESS_WRAP;
  c.padding_px = random.in(0, 4);
  c.flip_target = random.percent(20);
  c.flip_texture = random.percent(20);
  c.layout = random.pick({spec::Layout::kGiven, spec::Layout::kPadded, spec::Layout::kTiled});
  c.format = random.pick(kFormats);
  if (c.format == SELVAGE_RGBA8888 && random.percent(60)) {
    c.filter = random.pick({SELVAGE_FILTER_FOUR, SELVAGE_FILTER_BILINEAR});
  }
  const int32_t right = (c.target_width_px + random.in(-3, 400)) * kPixel_fx8;
  const int32_t left = random.in(-400, 3) * kPixel_fx8, slant = random.in(-600, 600);
  const int32_t low = (c.target_height_px + 1) * kPixel_fx8 + random.in(-400, 2000);
  c.vertices = {{left, -random.in(1, 999), 0, 0, 1},
                {right, -random.in(1, 999), 0, 0, 1},
                {right + slant, low, 0, 0, 1},
                {left + slant / 2, low + random.in(-200, 900), 0, 0, 1}};
  if (random.percent(60)) c.vertices.erase(c.vertices.begin() + random.in(0, 4));
  set_coordinates(random, &c);
  if (random.percent(30)) wide.tolerance = random.pick({256, 4096, kTexel_fx16 / 2, kTexel_fx16});
  return wide;
}

// A block of seeds.
class WideRows : public testing::TestWithParam<uint64_t> {};

TEST_P(WideRows, EveryKernelDrawsWhatTheScalarOneDraws) {
  constexpr uint64_t kSeeds = 200;
  for (uint64_t seed = GetParam() * kSeeds; seed < (GetParam() + 1) * kSeeds; ++seed) {
    const WideCase wide = any_wide_case(seed);
    for (const int32_t tolerance : {0, wide.tolerance}) {
      const spec::Canvas scalar = drawing_of(wide.c, SELVAGE_KERNEL_SCALAR, tolerance);
      for (const selvage_kernel kernel : tolerance == 0 ? usable_kernels() : stepping_kernels()) {
        ASSERT_TRUE(drawing_of(wide.c, kernel, tolerance) == scalar)
            << "kernel " << kernel << ", tolerance " << tolerance << ", seed " << seed << "\n"
            << spec::print(wide.c);
      }
      if (wide.tolerance == 0) break;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Block, WideRows, testing::Range(uint64_t{0}, uint64_t{20}));

}  // namespace
}  // namespace selvage::mapper
