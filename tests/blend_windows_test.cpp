// Where the vector kernels permute the rows of small windows to mix four texels: every size of
// texture about a window's, slopes about those at which one no longer holds all texels, seams and
// ends of the texture in the middle of vectors, and nothing but the texture to read.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

#include "spec/random.h"
#include "spec/vertex_units.h"
#include "tests/fenced_bytes.h"
#include "tests/kernel_support.h"

namespace selvage::mapper {
namespace {

using spec::kPixel_fx8;
using spec::kTexel_fx16;

struct TextureShape {
  int32_t width_texel, height_texel, pitch_texel;
  bool flipped;
};

struct Drawing {
  TextureShape texture;
  int32_t width_px, height_px;
  selvage_address address;
  selvage_filter filter;
  std::vector<selvage_vertex> vertices;
};

// Vectors of 16 pixels, or of 8, span whole numbers of texels, or a hair less or more; or any
// number.
[[nodiscard]] double any_slope(spec::Random& random) {
  const int32_t sign = random.percent(50) ? 1 : -1;
  if (random.percent(20)) return sign * random.in(0, 257) / 256.0;
  if (random.percent(20)) return sign * random.in(0, 1200) / 1000.0;
  return sign * (random.in(0, 16) / random.pick({7.0, 15.0}) + random.in(-1, 2) / 4096.0);
}

[[nodiscard]] TextureShape any_texture(spec::Random& random) {
  static constexpr int32_t kWidths[] = {1, 2, 7, 8, 9, 15, 16, 17, 31, 32, 64, 67, 100, 120, 200};
  static constexpr int32_t kHeights[] = {1, 2, 3, 4, 5, 6, 7, 8, 9, 16, 23, 24, 32, 50, 120};
  const int32_t width_texel = random.pick(kWidths);
  return {width_texel, random.pick(kHeights), width_texel + (random.percent(50) ? 0 : 3),
          random.percent(30)};
}

[[nodiscard]] Drawing any_drawing(uint64_t seed, bool perspective) {
  spec::Random random(seed);
  Drawing drawing{any_texture(random),
                  random.in(1, 120),
                  random.in(1, 40),
                  random.percent(50) ? SELVAGE_ADDRESS_CLAMP : SELVAGE_ADDRESS_WRAP,
                  random.percent(70) ? SELVAGE_FILTER_BILINEAR : SELVAGE_FILTER_FOUR,
                  {}};
  const double ux = any_slope(random), uy = any_slope(random);
  const double vx = any_slope(random), vy = any_slope(random);
  const int32_t beyond = random.percent(20) ? 400 : 20;
  const double u =
      random.in(-beyond, drawing.texture.width_texel + beyond) + random.in(0, 512) / 512.0;
  const double v =
      random.in(-beyond, drawing.texture.height_texel + beyond) + random.in(0, 512) / 512.0;
  const auto fx16 = [](double texel) { return static_cast<int32_t>(std::lround(texel * 65536)); };
  const int32_t q = random.pick({256, 1000, 65536});
  for (int corner = 0; corner < 3; ++corner) {
    const int32_t x_fx8 = random.in(-2000, 32000), y_fx8 = random.in(-2000, 12000);
    const double x_px = x_fx8 / 256.0, y_px = y_fx8 / 256.0;
    drawing.vertices.push_back({x_fx8, y_fx8, fx16(u + x_px * ux + y_px * uy),
                                fx16(v + x_px * vx + y_px * vy),
                                perspective ? q + random.in(0, q / 4) : 1});
  }
  return drawing;
}

// The texture ends, or begins, at memory that may not be touched.
[[nodiscard]] std::vector<uint32_t> drawn_fenced(const Drawing& of, selvage_kernel kernel,
                                                 FencedBytes::Side side) {
  constexpr auto kBytes = sizeof(uint32_t);
  const TextureShape& texture = of.texture;
  const auto last_row = static_cast<size_t>(texture.height_texel - 1);
  const auto pitch_texel = static_cast<size_t>(texture.pitch_texel);
  const size_t texels = last_row * pitch_texel + static_cast<size_t>(texture.width_texel);
  const FencedBytes memory(texels * kBytes, side);
  for (size_t i = 0; i < texels; ++i) {
    const uint32_t texel = static_cast<uint32_t>(i + 1) * 2654435761U;
    std::memcpy(memory.first() + i * kBytes, &texel, kBytes);
  }
  const auto pitch = static_cast<ptrdiff_t>(pitch_texel * kBytes);
  const selvage_texture view{
      memory.first() + (texture.flipped ? static_cast<ptrdiff_t>(last_row) * pitch : 0),
      texture.width_texel,
      texture.height_texel,
      texture.flipped ? -pitch : pitch,
      SELVAGE_RGBA8888,
      SELVAGE_LAYOUT_ROWS,
      nullptr};
  std::vector<uint32_t> pixels(static_cast<size_t>(of.width_px * of.height_px), 0x11111111);
  const selvage_image image{pixels.data(), of.width_px, of.height_px,
                            of.width_px * ptrdiff_t{kBytes}, SELVAGE_RGBA8888};
  selvage_options options{};
  options.filter = of.filter;
  options.address = of.address;
  options.kernel = kernel;
  EXPECT_EQ(selvage_draw(&image, nullptr, of.vertices.data(), of.vertices.size(), &view, &options),
            SELVAGE_OK);
  return pixels;
}

void expect_fenced_alike(const Drawing& drawing, FencedBytes::Side side) {
  const std::vector<uint32_t> wanted = drawn_fenced(drawing, SELVAGE_KERNEL_SCALAR, side);
  for (const selvage_kernel kernel : usable_kernels()) {
    ASSERT_TRUE(drawn_fenced(drawing, kernel, side) == wanted)
        << "kernel " << kernel << ", filter " << drawing.filter << ", address " << drawing.address
        << ", texture " << drawing.texture.width_texel << " x " << drawing.texture.height_texel;
  }
}

void expect_all_kernels_draw_the_same(bool perspective) {
  constexpr uint64_t kDrawings = 10000;
  for (uint64_t seed = 1; seed <= kDrawings; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const auto side = seed % 2 == 0 ? FencedBytes::Side::kFirst : FencedBytes::Side::kLast;
    ASSERT_NO_FATAL_FAILURE(expect_fenced_alike(any_drawing(seed, perspective), side));
  }
}

TEST(BlendWindows, KernelsDrawTheSame) { expect_all_kernels_draw_the_same(false); }

TEST(BlendWindows, KernelsDrawTheSameInPerspective) { expect_all_kernels_draw_the_same(true); }

// A third of a texel a pixel from a step of the grid on, or u on such a step everywhere: so many
// vectors have near-ties that they are not all left at once.
TEST(BlendWindows, KernelsDrawTheSameWhereAllIsNear) {
  constexpr int32_t first = kPixel_fx8 / 2, end = first + 900 * kPixel_fx8;
  constexpr int32_t u = kTexel_fx16 / 2, far = u + 300 * kTexel_fx16;
  const std::vector<selvage_vertex> thirds{
      {first, first, u, u, 1}, {end, first, far, u, 1}, {first, end, u, far, 1}};
  const std::vector<selvage_vertex> steps{
      {first, first, u, u, 1000}, {end, first, u, far, 1300}, {first, end, u, u, 1600}};
  for (const auto& vertices : {thirds, steps}) {
    for (const selvage_filter filter : {SELVAGE_FILTER_BILINEAR, SELVAGE_FILTER_FOUR}) {
      for (const selvage_address address : {SELVAGE_ADDRESS_CLAMP, SELVAGE_ADDRESS_WRAP}) {
        expect_fenced_alike({{64, 64, 64, false}, 300, 90, address, filter, vertices},
                            FencedBytes::Side::kLast);
      }
    }
  }
}

// Steps of 1/16 texel, from any such place on: in some vector of each slope the last pixel lies on
// a whole texel, which may be the first one that a window of fewer rows lacks.
TEST(BlendWindows, KernelsDrawTheSameWherePixelsLieOnTexels) {
  constexpr int32_t first = kPixel_fx8 / 2, kSide_px = 64, end = first + kSide_px * kPixel_fx8;
  constexpr int32_t kSixteenth_fx16 = kTexel_fx16 / 16;
  for (int32_t step = -16; step <= 16; ++step) {
    for (int32_t place = 0; place < 16; ++place) {
      for (const int32_t across : {1, 8, 15}) {
        SCOPED_TRACE("steps of " + std::to_string(across) + " and " + std::to_string(step) +
                     " sixteenths, from " + std::to_string(place) + " on");
        const int32_t u = kTexel_fx16, v = 66 * kTexel_fx16 + place * kSixteenth_fx16;
        const int32_t far_u = u + kSide_px * across * kSixteenth_fx16;
        const int32_t far_v = v + kSide_px * step * kSixteenth_fx16;
        const std::vector<selvage_vertex> vertices{
            {first, first, u, v, 1}, {end, first, far_u, far_v, 1}, {first, end, u, v, 1}};
        ASSERT_NO_FATAL_FAILURE(expect_fenced_alike({{64, 132, 64, false},
                                                     kSide_px,
                                                     4,
                                                     SELVAGE_ADDRESS_CLAMP,
                                                     SELVAGE_FILTER_BILINEAR,
                                                     vertices},
                                                    FencedBytes::Side::kLast));
      }
    }
  }
}

// u and v a hair off a step of the grid everywhere: two vertices lie on one, the third is a unit
// off, far away and of little weight.
TEST(BlendWindows, KernelsDrawTheSameWhereAllIsAHairOff) {
  constexpr int32_t kGrid_fx16 = kTexel_fx16 / 256, kWidth_px = 90, kHeight_px = 12;
  for (uint64_t seed = 1; seed <= 6000; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    spec::Random random(seed);
    const int32_t q = random.pick({1, 16, 300, 1000}), far_px = random.pick({300, 3000, 20000});
    const int32_t u = random.in(-32000, 32000) * kTexel_fx16 + random.in(0, 256) * kGrid_fx16;
    const int32_t v = random.in(0, 64) * kTexel_fx16 + random.in(0, 256) * kGrid_fx16;
    const auto subpixels = [&](int32_t px) { return px * kPixel_fx8 + random.in(0, 256); };
    const auto large_q = [&] { return q * (1 << 14) - random.in(0, q * (1 << 11)); };
    const std::vector<selvage_vertex> vertices{
        {subpixels(-far_px), subpixels(-5), u + random.in(-1, 2), v + random.in(-1, 2), q},
        {subpixels(kWidth_px + 50), subpixels(-random.in(1, 100)), u, v, large_q()},
        {subpixels(random.in(0, kWidth_px)), subpixels(kHeight_px + 40), u, v, large_q()}};
    ASSERT_NO_FATAL_FAILURE(expect_fenced_alike({{64, 64, 64, false},
                                                 kWidth_px,
                                                 kHeight_px,
                                                 SELVAGE_ADDRESS_WRAP,
                                                 SELVAGE_FILTER_BILINEAR,
                                                 vertices},
                                                FencedBytes::Side::kLast));
  }
}

}  // namespace
}  // namespace selvage::mapper
