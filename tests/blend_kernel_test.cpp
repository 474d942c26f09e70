// The filters over four texels, by every kernel that this machine can run.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <vector>

#include "mapper/layout.h"
#include "tests/kernel_support.h"

namespace selvage::mapper {
namespace {

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

constexpr int32_t kPicture_px = 256, kChannels = 4;
using Picture = std::vector<uint8_t>;

// All that the texture has, or some of it: a kernel may take other ways then.
enum class Texels { kAll, kSome };

// Of 16 x 8, the four texels in the middle.
[[nodiscard]] Picture among_others(const std::array<uint8_t, 16>& texels) {
  constexpr size_t kRow = 16 * kChannels, kPair = 2 * kChannels;
  Picture all(8 * kRow, 0x77);
  const auto first = all.begin() + 3 * kRow + 7 * kChannels;
  std::copy(texels.begin(), texels.begin() + kPair, first);
  std::copy(texels.begin() + kPair, texels.end(), first + kRow);
  return all;
}

// Pixel (i, j) has the weights i / 256 and j / 256: from texel to texel in 256 pixels, of which the
// first `side_px` are drawn.
[[nodiscard]] Picture picture_of_weights(const std::array<uint8_t, 16>& texels, Texels are,
                                         selvage_filter filter, selvage_kernel kernel,
                                         int32_t side_px) {
  constexpr int32_t px = SELVAGE_SUBPIXELS, texel = SELVAGE_SUBTEXELS;
  const bool some = are == Texels::kSome;
  const Picture others = among_others(texels);
  const int32_t first = texel / 2 - texel / 512, walk = 4 * texel;
  const int32_t u = first + (some ? 7 * texel : 0), v = first + (some ? 3 * texel : 0);
  const std::array<selvage_vertex, 3> corner{{{0, 0, u, v, 1},
                                              {4 * kPicture_px * px, 0, u + walk, v, 1},
                                              {0, 4 * kPicture_px * px, u, v + walk, 1}}};
  Picture picture(static_cast<size_t>(side_px * side_px * kChannels), 0x5A);
  const selvage_image target{picture.data(), side_px, side_px, side_px * kChannels,
                             SELVAGE_RGBA8888};
  const int32_t width_texel = some ? 16 : 2, height_texel = some ? 8 : 2;
  const selvage_texture texture{some ? others.data() : texels.data(),
                                width_texel,
                                height_texel,
                                width_texel * kChannels,
                                SELVAGE_RGBA8888,
                                SELVAGE_LAYOUT_ROWS,
                                nullptr};
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
    for (int32_t j = 0; j < kPicture_px; ++j) {
      for (int32_t i = 0; i < kPicture_px; ++i) {
        for (const Corners& c : channels) {
          wanted.push_back(static_cast<uint8_t>(bilinear(c, i, j)));
        }
      }
    }
    for (const selvage_kernel kernel : usable_kernels()) {
      if (kernel == SELVAGE_KERNEL_SCALAR) continue;
      for (const Texels are : {Texels::kAll, Texels::kSome}) {
        ASSERT_EQ(picture_of_weights(texels_of(channels), are, SELVAGE_FILTER_BILINEAR, kernel,
                                     kPicture_px) == wanted,
                  true)
            << "kernel " << kernel << ", red corners " << channels[0].upper_left << ' '
            << channels[0].upper_right << ' ' << channels[0].lower_left << ' '
            << channels[0].lower_right;
      }
    }
  });
}

// More than a vector, and a part of one.
constexpr int32_t kFour_px = 21;

TEST(BlendKernel, MeanOfFourIsByItsOwnFormula) {
  for_hard_corners([](const std::array<Corners, kChannels>& channels) {
    Picture wanted;
    for (int32_t k = 0; k < kFour_px * kFour_px; ++k) {
      for (const Corners& c : channels) wanted.push_back(static_cast<uint8_t>(four(c)));
    }
    for (const selvage_kernel kernel : usable_kernels()) {
      for (const Texels are : {Texels::kAll, Texels::kSome}) {
        ASSERT_EQ(picture_of_weights(texels_of(channels), are, SELVAGE_FILTER_FOUR, kernel,
                                     kFour_px) == wanted,
                  true)
            << "kernel " << kernel << ", red corners " << channels[0].upper_left << ' '
            << channels[0].upper_right << ' ' << channels[0].lower_left << ' '
            << channels[0].lower_right;
      }
    }
  });
}

}  // namespace
}  // namespace selvage::mapper
