// The filters over four texels, by every kernel that this machine can run.
#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <random>
#include <vector>

#include "mapper/interior.h"
#include "mapper/kernel.h"
#include "mapper/layout.h"

namespace selvage::mapper {
namespace {

[[nodiscard]] std::vector<selvage_kernel> usable_kernels() {
  std::vector<selvage_kernel> usable;
  for (selvage_kernel each = SELVAGE_KERNEL_SCALAR; each <= SELVAGE_KERNEL_NEON; ++each) {
    if (is_usable(each)) usable.push_back(each);
  }
  return usable;
}

struct Corners {
  int32_t upper_left, upper_right, lower_left, lower_right;
};

// Of one channel, as the specification has it.
[[nodiscard]] int32_t bilinear(const Corners& c, int32_t right, int32_t lower) {
  const int32_t left = 256 - right, upper = 256 - lower;
  return (c.upper_left * left * upper + c.upper_right * right * upper +
          c.lower_left * left * lower + c.lower_right * right * lower + 32768) >>
         16;
}

[[nodiscard]] int32_t four(const Corners& c) {
  return (c.upper_left + c.upper_right + c.lower_left + c.lower_right + 2) >> 2;
}

constexpr int32_t kSide_px = 256, kChannels = 4;
using Picture = std::vector<uint8_t>;

// Pixel (i, j) has the weights i / 256 and j / 256: from texel to texel in 256 pixels.
[[nodiscard]] Picture drawn(const std::array<uint8_t, 16>& texels, selvage_filter filter,
                            selvage_kernel kernel) {
  constexpr int32_t px = SELVAGE_SUBPIXELS, texel = SELVAGE_SUBTEXELS;
  constexpr int32_t u = texel / 2 - texel / 512, far = texel / 2 - texel / 512 + 4 * texel;
  const std::array<selvage_vertex, 3> corner{
      {{0, 0, u, u, 1}, {4 * kSide_px * px, 0, far, u, 1}, {0, 4 * kSide_px * px, u, far, 1}}};
  Picture picture(kSide_px * kSide_px * kChannels, 0x5A);
  const selvage_image target{picture.data(), kSide_px, kSide_px, kSide_px * kChannels,
                             SELVAGE_RGBA8888};
  const selvage_texture texture{texels.data(),       2,      2, 2 * kChannels, SELVAGE_RGBA8888,
                                SELVAGE_LAYOUT_ROWS, nullptr};
  selvage_options options{};
  options.filter = filter;
  options.kernel = kernel;
  EXPECT_EQ(selvage_draw(&target, nullptr, corner.data(), corner.size(), &texture, &options),
            SELVAGE_OK);
  return picture;
}

// Those that are near a carry or the end of a range somewhere.
constexpr std::array<int32_t, 7> kHardLevels = {0, 1, 2, 127, 128, 254, 255};

// All of their combinations, four at a time: one a channel.
template <class Check>
void for_hard_corners(const Check& check) {
  constexpr size_t n = kHardLevels.size();
  std::array<Corners, kChannels> channels{};
  for (size_t i = 0; i < n * n * n * n; ++i) {
    channels[i % kChannels] = {kHardLevels[i % n], kHardLevels[i / n % n],
                               kHardLevels[i / (n * n) % n], kHardLevels[i / (n * n * n)]};
    if (i % kChannels == kChannels - 1 || i + 1 == n * n * n * n) check(channels);
  }
}

[[nodiscard]] std::array<uint8_t, 16> texels_of(const std::array<Corners, kChannels>& channels) {
  std::array<uint8_t, 16> texels{};
  for (size_t c = 0; c < kChannels; ++c) {
    texels[c] = static_cast<uint8_t>(channels[c].upper_left);
    texels[kChannels + c] = static_cast<uint8_t>(channels[c].upper_right);
    texels[2 * kChannels + c] = static_cast<uint8_t>(channels[c].lower_left);
    texels[3 * kChannels + c] = static_cast<uint8_t>(channels[c].lower_right);
  }
  return texels;
}

TEST(BlendKernel, MixesByTheFormulaWhateverTheWeights) {
  for_hard_corners([](const std::array<Corners, kChannels>& channels) {
    Picture wanted;
    for (int32_t j = 0; j < kSide_px; ++j) {
      for (int32_t i = 0; i < kSide_px; ++i) {
        for (const Corners& c : channels) {
          wanted.push_back(static_cast<uint8_t>(bilinear(c, i, j)));
        }
      }
    }
    for (const selvage_kernel kernel : usable_kernels()) {
      if (kernel == SELVAGE_KERNEL_SCALAR) continue;
      ASSERT_EQ(drawn(texels_of(channels), SELVAGE_FILTER_BILINEAR, kernel) == wanted, true)
          << "kernel " << kernel << ", red corners " << channels[0].upper_left << ' '
          << channels[0].upper_right << ' ' << channels[0].lower_left << ' '
          << channels[0].lower_right;
    }
  });
}

TEST(BlendKernel, MeanOfFourIsByItsOwnFormula) {
  for_hard_corners([](const std::array<Corners, kChannels>& channels) {
    for (const selvage_kernel kernel : usable_kernels()) {
      const Picture picture = drawn(texels_of(channels), SELVAGE_FILTER_FOUR, kernel);
      for (size_t c = 0; c < kChannels; ++c) {
        ASSERT_EQ(picture[c], four(channels[c])) << "kernel " << kernel;
        ASSERT_EQ(picture[picture.size() - kChannels + c], four(channels[c]));
      }
    }
  });
}

// ---- The interior
// --------------------------------------------------------------------------------

[[nodiscard]] bool is_inside(int64_t lane_fx32, int32_t size_texel, uint32_t margin_fx32) {
  const int64_t from_first_centre = lane_fx32 - (int64_t{1} << (kLaneFraction - 1));
  return from_first_centre >= 0 && from_first_centre + margin_fx32 <= int64_t{size_texel - 1}
                                                                          << kLaneFraction;
}

TEST(Interior, HoldsOnlyWhatIsInsideAndLacksLittle) {
  constexpr uint64_t kSeed = 1;
  std::mt19937_64 random(kSeed);
  const auto between = [&](int64_t low, int64_t high) {
    return low + static_cast<int64_t>(random() % static_cast<uint64_t>(high - low + 1));
  };
  constexpr int64_t kOne = int64_t{1} << kLaneFraction;
  for (int32_t i = 0; i < 20000; ++i) {
    const auto width = static_cast<int32_t>(between(1, 300));
    const auto height = static_cast<int32_t>(between(1, 300));
    const int64_t steepest = kOne >> between(0, 32);
    AffineField field{};
    field.start = {between(-100 * kOne, 400 * kOne), between(-100 * kOne, 400 * kOne)};
    field.step_x = {between(-steepest, steepest), between(-1, 1) * between(0, steepest)};
    field.margin_fx32 = static_cast<uint32_t>(between(1, 4096));
    const Span span{0, 0, static_cast<int32_t>(between(1, 2000))};
    selvage_texture texture{};
    texture.width = width;
    texture.height = height;
    const Span inner = Interior(field, texture).of(span);
    ASSERT_LE(span.left_px, inner.left_px) << "seed " << kSeed << ", case " << i;
    ASSERT_LE(inner.left_px, inner.right_px) << "seed " << kSeed << ", case " << i;
    ASSERT_LE(inner.right_px, span.right_px) << "seed " << kSeed << ", case " << i;
    int32_t inside = 0;
    for (int32_t px = 0; px < span.right_px; ++px) {
      const Lane lane = field.at(px, 0);
      const bool is = is_inside(lane.u_fx32, width, field.margin_fx32) &&
                      is_inside(lane.v_fx32, height, field.margin_fx32);
      inside += is ? 1 : 0;
      if (inner.left_px <= px && px < inner.right_px) {
        ASSERT_TRUE(is) << "pixel " << px << ", seed " << kSeed << ", case " << i;
      }
    }
    constexpr int32_t kLacks_px = 6;  // three at each end
    ASSERT_LE(inside - inner.width_px(), kLacks_px) << "seed " << kSeed << ", case " << i;
    texture.layout = SELVAGE_LAYOUT_TILES;
    ASSERT_TRUE(Interior(field, texture).of(span).empty());
  }
}

}  // namespace
}  // namespace selvage::mapper
