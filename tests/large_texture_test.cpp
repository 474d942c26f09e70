// Textures that no cache holds, whose texels are asked for ahead: every kernel draws what the
// scalar one draws, and reads nothing beyond the texture.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include "mapper/vector/kernel.h"
#include "spec/random.h"
#include "spec/vertex_units.h"
#include "tests/fenced_bytes.h"
#include "tests/kernel_support.h"

namespace selvage::mapper {
namespace {

using spec::kPixel_fx8;
using spec::kTexel_fx16;

constexpr int kCasesPerTexture = 40;

struct TextureKind {
  selvage_format format;
  int32_t width_texel, height_texel;
  selvage_layout layout;
};

// The least ones that are not cached, and one whose sides are powers of two.
constexpr TextureKind kKinds[] = {
    {SELVAGE_RGBA8888, 2049, 1024, SELVAGE_LAYOUT_ROWS},
    {SELVAGE_RGBA8888, 2048, 2048, SELVAGE_LAYOUT_ROWS},
    {SELVAGE_RGBA8888, 2049, 1024, SELVAGE_LAYOUT_TILES},
    {SELVAGE_RGB565, 2049, 2048, SELVAGE_LAYOUT_ROWS},
    {SELVAGE_INDEX8, 4097, 2048, SELVAGE_LAYOUT_ROWS},
};

// Noise between pages that must not be touched.
class LargeTexture {
 public:
  LargeTexture(const TextureKind& kind, FencedBytes::Side side)
      : given_(static_cast<size_t>(pitch_of(kind)) * static_cast<size_t>(kind.height_texel), side) {
    spec::Random random(1);
    for (ptrdiff_t at = 0; at < pitch_of(kind) * kind.height_texel; ++at) {
      given_.first()[at] = static_cast<char>(random.in(0, 256));
    }
    view_.texels = given_.first();
    view_.width = kind.width_texel;
    view_.height = kind.height_texel;
    view_.pitch = pitch_of(kind);
    view_.format = kind.format;
    if (kind.layout == SELVAGE_LAYOUT_ROWS) return;
    const size_t bytes = selvage_prepare_bytes(&view_, kind.layout, 0);
    memory_.resize(bytes / sizeof(Line) + 1);
    const selvage_texture rows = view_;
    EXPECT_EQ(selvage_prepare(&rows, kind.layout, 0, memory_.data(), bytes, &view_), SELVAGE_OK);
  }

  [[nodiscard]] const selvage_texture& view() const { return view_; }

 private:
  struct alignas(SELVAGE_PREPARED_ALIGNMENT) Line {
    char bytes[SELVAGE_PREPARED_ALIGNMENT];
  };
  static ptrdiff_t pitch_of(const TextureKind& kind) {
    return kind.width_texel * bytes_per_pixel(kind.format);
  }

  FencedBytes given_;
  std::vector<Line> memory_;
  selvage_texture view_{};
};

// A triangle over more than a batch of rows, or over few short ones; u and v step by a texel a
// pixel or more, from whole texels, so that many samples are ties, or from anywhere.
[[nodiscard]] spec::Case any_case_on(uint64_t seed, const selvage_texture& texture) {
  spec::Random random(seed);
  spec::Case c;
  c.format = texture.format;
  c.address = random.percent(50) ? SELVAGE_ADDRESS_CLAMP : SELVAGE_ADDRESS_WRAP;
  const bool large = random.percent(60);
  c.target_width_px = large ? random.in(300, 700) : random.in(34, 80);
  c.target_height_px = large ? random.in(60, 90) : random.in(1, 9);
  c.padding_px = random.in(0, 4);
  const double scale = random.pick({1.0, 1.5, 2.0, 2.8, 4.0, 7.0});
  const double degrees = random.pick({0, 23, 90, 180, 203, 270, 315});
  const double angle = degrees * std::numbers::pi / 180;
  const double cos = std::cos(angle) * scale, sin = std::sin(angle) * scale;
  const int32_t u_fx16 = random.in(0, texture.width) * kTexel_fx16 + random.pick({0, 12345});
  const int32_t v_fx16 = random.in(0, texture.height) * kTexel_fx16 + random.pick({0, 54321});
  const int32_t depth = random.pick({1, 2, 20});
  c.vertices = {{-9 * kPixel_fx8, -kPixel_fx8, 0, 0, random.in(1, depth + 1)},
                {(c.target_width_px + 50) * kPixel_fx8, -kPixel_fx8, 0, 0, random.in(1, depth + 1)},
                {random.in(0, 300) * kPixel_fx8, 2 * c.target_height_px * kPixel_fx8, 0, 0,
                 random.in(1, depth + 1)}};
  for (selvage_vertex& vertex : c.vertices) {
    const double x = vertex.x * double{kTexel_fx16} / kPixel_fx8;
    const double y = vertex.y * double{kTexel_fx16} / kPixel_fx8;
    vertex.u = u_fx16 + static_cast<int32_t>(std::lround(x * cos - y * sin));
    vertex.v = v_fx16 + static_cast<int32_t>(std::lround(x * sin + y * cos));
  }
  return c;
}

[[nodiscard]] spec::Canvas drawing_from(const spec::Case& c, const selvage_texture& texture,
                                        selvage_kernel kernel) {
  spec::Canvas target(c.format, c.target_width_px, c.target_height_px, c.padding_px, false, 0x11);
  const selvage_image image = target.image();
  selvage_options options{};
  options.address = c.address;
  options.kernel = kernel;
  EXPECT_EQ(selvage_draw(&image, nullptr, c.vertices.data(), c.vertices.size(), &texture, &options),
            SELVAGE_OK);
  return target;
}

class LargeTextures : public testing::TestWithParam<size_t> {};

TEST_P(LargeTextures, AreDrawnByEveryKernelAsByTheScalarOne) {
  for (const auto side : {FencedBytes::Side::kFirst, FencedBytes::Side::kLast}) {
    const LargeTexture texture(kKinds[GetParam()], side);
    ASSERT_FALSE(is_cached(texture.view()));
    for (uint64_t seed = 1; seed <= kCasesPerTexture; ++seed) {
      const spec::Case c = any_case_on(seed, texture.view());
      const spec::Canvas scalar = drawing_from(c, texture.view(), SELVAGE_KERNEL_SCALAR);
      for (const selvage_kernel kernel : usable_kernels()) {
        ASSERT_TRUE(drawing_from(c, texture.view(), kernel) == scalar)
            << "kernel " << kernel << ", seed " << seed << "\n"
            << spec::print(c);
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Kind, LargeTextures, testing::Range(size_t{0}, std::size(kKinds)));

TEST(LargeTextures, HaveMoreThanEightMegabytes) {
  selvage_texture texture{};
  for (const selvage_format format : {SELVAGE_INDEX8, SELVAGE_RGB565, SELVAGE_RGBA8888}) {
    texture.format = format;
    texture.width = 1024;
    texture.height = 8192 / static_cast<int32_t>(bytes_per_pixel(format));
    EXPECT_TRUE(is_cached(texture));
    ++texture.height;
    EXPECT_FALSE(is_cached(texture));
    texture.width = texture.height = 1 << 16;
    EXPECT_FALSE(is_cached(texture));
  }
  texture.format = SELVAGE_INDEX8;
  texture.width = 3;
  texture.height = kCached_bytes / 3 + 1;
  ASSERT_EQ(texture.width * texture.height, (8 << 20) + 1);
  EXPECT_FALSE(is_cached(texture));
}

}  // namespace
}  // namespace selvage::mapper
