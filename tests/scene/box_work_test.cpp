// What sums would spare the area filter: by hand, and against all pixels of the model.
#include "scene/box_work.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "spec/gradient.h"

namespace selvage::scene {
namespace {

inline constexpr selvage_options kArea{SELVAGE_PROFILE_EXACT, SELVAGE_FILTER_AREA,
                                       SELVAGE_ADDRESS_WRAP, 0, SELVAGE_KERNEL_FASTEST};
inline constexpr selvage_rect kWhole{0, 0, 1000, 1000};

[[nodiscard]] TextureImage image(int32_t width_texel, int32_t height_texel) {
  return {width_texel, height_texel, {}, SELVAGE_ADDRESS_WRAP};
}

struct Map {  // texels a pixel
  int32_t u_along_x, u_along_y, v_along_x, v_along_y;
};

// 20 px wide, 10 high.
[[nodiscard]] std::vector<selvage_vertex> rectangle(const Map& map, int32_t q = 7) {
  std::vector<selvage_vertex> corners;
  for (const auto& [x, y] : {std::pair{0, 0}, {20, 0}, {20, 10}, {0, 10}}) {
    corners.push_back({(30 + x) * SELVAGE_SUBPIXELS, (40 + y) * SELVAGE_SUBPIXELS,
                       (map.u_along_x * x + map.u_along_y * y) * SELVAGE_SUBTEXELS,
                       (map.v_along_x * x + map.v_along_y * y) * SELVAGE_SUBTEXELS, q});
  }
  return corners;
}

TEST(BoxWork, IsThatOfTheTexelsUnderBoxesLessLookingThemUp) {
  const TextureImage large = image(1000, 1000);
  const auto spared = [&](const Map& map) {
    return spared_texels(large, rectangle(map), kArea, kWhole);
  };
  EXPECT_NEAR(spared({40, 0, 0, 30}), 200 * (41 * 31 - 128), 0.01);
  EXPECT_NEAR(spared({-40, 5, 0, -30}), 200 * (46 * 31 - 128), 0.01);
  EXPECT_NEAR(spared({40, -5, 7, 30}), 200 * (46 * 38 - 128), 0.01);
  EXPECT_NEAR(spared({0, 12, 12, 0}), 200 * (13 * 13 - 128), 0.01);
  EXPECT_EQ(spared({10, 0, 0, 10}), 0) << "121 texels are visited in any case";
}

TEST(BoxWork, EndsWithTheTexture) {
  const auto spared = [&](int32_t width_texel, int32_t height_texel) {
    return spared_texels(image(width_texel, height_texel), rectangle({40, 0, 0, 30}), kArea,
                         kWhole);
  };
  EXPECT_NEAR(spared(25, 1000), 200 * (25 * 31 - 128), 0.01);
  EXPECT_NEAR(spared(1000, 20), 200 * (41 * 20 - 128), 0.01);
  EXPECT_NEAR(spared(41, 31), 200 * (41 * 31 - 128), 0.01);
  EXPECT_EQ(spared(11, 11), 0);
}

TEST(BoxWork, IsOfWhatTheClipLeaves) {
  const auto share = [](const selvage_rect& clip) {
    const std::vector<selvage_vertex> corners = rectangle({40, 0, 0, 30});
    return spared_texels(image(1000, 1000), corners, kArea, clip) /
           spared_texels(image(1000, 1000), corners, kArea, kWhole);
  };
  EXPECT_NEAR(share({35, 0, 1000, 1000}), 0.75, 1e-9);
  EXPECT_NEAR(share({0, 0, 35, 1000}), 0.25, 1e-9);
  EXPECT_NEAR(share({0, 42, 1000, 1000}), 0.8, 1e-9);
  EXPECT_NEAR(share({0, 0, 1000, 42}), 0.2, 1e-9);
  EXPECT_NEAR(share({35, 42, 45, 47}), 0.25, 1e-9);
  EXPECT_EQ(share({50, 0, 1000, 1000}), 0);
  EXPECT_EQ(share({60, 0, 1000, 1000}), 0);
  EXPECT_EQ(share({0, 0, 1000, 30}), 0);
}

TEST(BoxWork, IsNothingForOtherFiltersAndWithoutArea) {
  const TextureImage large = image(1000, 1000);
  for (const selvage_filter filter :
       {SELVAGE_FILTER_NEAREST, SELVAGE_FILTER_FOUR, SELVAGE_FILTER_BILINEAR}) {
    selvage_options options = kArea;
    options.filter = filter;
    EXPECT_EQ(spared_texels(large, rectangle({40, 0, 0, 30}), options, kWhole), 0);
  }
  std::vector<selvage_vertex> flat = rectangle({40, 0, 0, 30});
  for (selvage_vertex& vertex : flat) vertex.y = 0;
  EXPECT_EQ(spared_texels(large, flat, kArea, kWhole), 0);
}

// The sum over all pixels within a clip rectangle.
[[nodiscard]] double by_pixels(std::span<const selvage_vertex> vertices, const selvage_rect& clip) {
  double sum = 0;
  for (int32_t y = clip.top; y < clip.bottom; ++y) {
    for (int32_t x = clip.left; x < clip.right; ++x) {
      const auto gradient = spec::gradient(vertices, x, y);
      if (!gradient) continue;
      const auto size = [](const spec::Rational& n) { return std::abs(n.get_d()); };
      const double u = size(gradient->u_along_x) + size(gradient->u_along_y);
      const double v = size(gradient->v_along_x) + size(gradient->v_along_y);
      sum += std::max(0.0, (u + 1) * (v + 1) - kLookingUp_texels);
    }
  }
  return sum;
}

TEST(BoxWork, IsNearlyTheModelsInPerspective) {
  constexpr int32_t px = SELVAGE_SUBPIXELS, texel = SELVAGE_SUBTEXELS;
  const std::vector<selvage_vertex> triangle = {{10 * px, 5 * px, 100 * texel, 50 * texel, 100},
                                                {90 * px, 15 * px, 3000 * texel, 900 * texel, 300},
                                                {30 * px, 80 * px, 400 * texel, 2500 * texel, 200}};
  for (const selvage_rect& clip :
       {selvage_rect{0, 0, 100, 100}, {10, 5, 40, 40}, {30, 20, 90, 90}}) {
    const double spared = spared_texels(image(10000, 10000), triangle, kArea, clip);
    EXPECT_NEAR(spared / by_pixels(triangle, clip), 1, 0.1) << clip.left << ", " << clip.top;
  }
}

// A floor up to its horizon, most of which lies beyond the clip rectangle, much nearer.
TEST(BoxWork, IsOfTheFarPartThatIsSeen) {
  constexpr int32_t px = SELVAGE_SUBPIXELS, texel = SELVAGE_SUBTEXELS;
  const std::vector<selvage_vertex> floor = {
      {30 * px, 10 * px, 0, 0, 100},
      {70 * px, 10 * px, 9000 * texel, 0, 100},
      {8050 * px, 4000 * px, 9000 * texel, 9000 * texel, 20050},
      {-7950 * px, 4000 * px, 0, 9000 * texel, 20050}};
  const selvage_rect clip{0, 0, 100, 60};
  const double ratio =
      spared_texels(image(10000, 10000), floor, kArea, clip) / by_pixels(floor, clip);
  EXPECT_GT(ratio, 0.5);
  EXPECT_LT(ratio, 3);
}

}  // namespace
}  // namespace selvage::scene
