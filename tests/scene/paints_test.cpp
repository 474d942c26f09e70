// Textures in their light, and what of them is lit.
#include "scene/paints.h"

#include <gtest/gtest.h>

#include <iostream>
#include <vector>

#include "chequered_texture.h"
#include "plane_face.h"
#include "scene/reach.h"

namespace selvage::scene {
namespace {

TEST(Paints, PutsTheLightIntoTheTexels) {
  Scene scene;
  scene.textures.push_back(chequered(4));
  Paints paints(scene);
  const selvage_texture unlit = paints.texture({0, {}, {}});
  EXPECT_EQ(unlit.texels, scene.textures[0].rgba.data());
  const selvage_texture half = paints.texture({0, {128, 64, 0}, {}});
  const auto* texel = static_cast<const uint8_t*>(half.texels) + 4;  // (1, 0): 200, 1, 7, 255
  EXPECT_EQ(texel[0], 100);
  EXPECT_EQ(texel[1], 0);
  EXPECT_EQ(texel[2], 0);
  EXPECT_EQ(texel[3], 255);
  EXPECT_EQ(paints.texture({0, {128, 64, 0}, {}}).texels, half.texels);  // one copy for all
  const selvage_texture colour = paints.texture({{}, {}, {9, 8, 7, 6}});
  EXPECT_EQ(colour.width, 1);
  EXPECT_EQ(static_cast<const uint8_t*>(colour.texels)[3], 6);
}

TEST(Paints, LightsNoTexelTwiceAndNoneThatIsNotAskedFor) {
  Scene scene;
  scene.textures.push_back(chequered(64));
  Paints paints(scene);
  const Paint half{0, {128, 128, 128}, {}};
  static_cast<void>(paints.texture(half, {10, 10, 20, 20}));
  EXPECT_EQ(paints.lit_texels(), 100);
  static_cast<void>(paints.texture(half, {12, 12, 18, 18}));
  EXPECT_EQ(paints.lit_texels(), 100);
  const selvage_texture more = paints.texture(half, {5, 15, 15, 30});
  EXPECT_EQ(paints.lit_texels(), 15 * 20);  // what holds both
  for (int32_t t = 10; t < 30; ++t) {
    for (int32_t s = 5; s < 20; ++s) {
      const size_t at = static_cast<size_t>(4 * (t * 64 + s));
      EXPECT_EQ(static_cast<const uint8_t*>(more.texels)[at], lit(scene.textures[0].rgba[at], 128));
    }
  }
  static_cast<void>(paints.texture(half, {10, 12, 40, 13}));
  EXPECT_EQ(paints.lit_texels(), 35 * 20);
  EXPECT_EQ(static_cast<const uint8_t*>(more.texels)[4 * (12 * 64 + 39)],
            lit(scene.textures[0].rgba[4 * (12 * 64 + 39)], 128));
  static_cast<void>(paints.texture({0, {}, {}}, {0, 0, 64, 64}));
  EXPECT_EQ(paints.lit_texels(), 700);
}

TEST(Paints, KeepsAsManyCopiesAsFit) {
  Scene scene;
  scene.textures.push_back(chequered(64));
  const selvage_rect texel{0, 0, 1, 1};
  const auto lit_in_rounds = [&](size_t most_bytes) {
    Paints paints(scene, most_bytes);
    for (int round = 0; round < 3; ++round) {
      for (const uint8_t level : {uint8_t{10}, uint8_t{20}, uint8_t{30}}) {
        static_cast<void>(paints.texture({0, {level, level, level}, {}}, texel));
      }
    }
    return paints.lit_texels();
  };
  EXPECT_EQ(lit_in_rounds(3 * 64 * 64 * 4), 3);
  EXPECT_EQ(lit_in_rounds(3 * 64 * 64 * 4 - 1), 9);
  EXPECT_EQ(lit_in_rounds(0), 9);
}

inline constexpr Size kReachTarget{64, 48};

// Its sides on pixel centres, the texture along them: pixels show the greatest u or v itself.
[[nodiscard]] ScreenFace upright_face(spec::Random& random, int32_t side_texel) {
  const int32_t left = 256 * random.in(0, 20) + 128, right = left + 256 * random.in(1, 40);
  const int32_t top = 256 * random.in(0, 20) + 128, bottom = top + 256 * random.in(1, 20);
  const int32_t u = random.in(0, side_texel * 65536), end_u = random.in(0, side_texel * 65536);
  const int32_t v = random.in(0, side_texel * 65536), end_v = random.in(0, side_texel * 65536);
  ScreenFace face;
  face.paint.texture = 0;
  face.vertices = {{left, top, u, v, 1},
                   {left, bottom, u, end_v, 1},
                   {right, bottom, end_u, end_v, 1},
                   {right, top, end_u, v, 1}};
  return face;
}

[[nodiscard]] ScreenFace random_face(spec::Random& random, int32_t side_texel) {
  ScreenFace face;
  face.paint.texture = 0;
  const bool is_flat = random.percent(30);
  const int32_t reach_texel = random.percent(50) ? side_texel : 4 * side_texel;
  const int corners = random.in(3, 6);
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * std::numbers::pi * i / corners + real(random, 0, 1);
    face.vertices.push_back({static_cast<int32_t>(256 * (32 + 40 * std::cos(angle))),
                             static_cast<int32_t>(256 * (24 + 40 * std::sin(angle))),
                             random.in(-reach_texel * 65536, reach_texel * 65536),
                             random.in(-reach_texel * 65536, reach_texel * 65536),
                             is_flat ? 1000 : random.in(300, 1000)});
  }
  return face;
}

// With other texels outside of the reach.
[[nodiscard]] std::vector<uint8_t> spoiled(const TextureImage& image, const selvage_rect& reach) {
  std::vector<uint8_t> texels = image.rgba;
  for (int32_t t = 0; t < image.height_texel; ++t) {
    for (int32_t s = 0; s < image.width_texel; ++s) {
      const bool within = s >= reach.left && s < reach.right && t >= reach.top && t < reach.bottom;
      for (size_t c = 0; c < 4 && !within; ++c) {
        uint8_t& part = texels[static_cast<size_t>(4 * (t * image.width_texel + s)) + c];
        part = static_cast<uint8_t>(~part);
      }
    }
  }
  return texels;
}

[[nodiscard]] std::vector<uint8_t> drawn(const ScreenFace& face, const Plan& plan,
                                         const TextureImage& image,
                                         const std::vector<uint8_t>& texels) {
  std::vector<uint8_t> pixels(
      static_cast<size_t>(kReachTarget.width_px * kReachTarget.height_px * 4));
  const selvage_image target{pixels.data(), kReachTarget.width_px, kReachTarget.height_px,
                             kReachTarget.width_px * 4, SELVAGE_RGBA8888};
  const selvage_texture texture{texels.data(),
                                image.width_texel,
                                image.height_texel,
                                image.width_texel * 4,
                                SELVAGE_RGBA8888,
                                SELVAGE_LAYOUT_ROWS,
                                nullptr};
  const std::vector<selvage_vertex> vertices = vertices_to_draw(face, plan);
  EXPECT_EQ(
      selvage_draw(&target, nullptr, vertices.data(), vertices.size(), &texture, &plan.options),
      SELVAGE_OK);
  return pixels;
}

TEST(Reach, HoldsEveryTexelThatIsShown) {
  int part_of_it = 0, tight = 0, tight_area = 0;
  for (uint64_t seed = 1; seed <= 600; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    spec::Random random(seed);
    const int32_t side_texel = random.in(8, 64);
    Scene scene;
    scene.textures.push_back(chequered(side_texel));
    scene.textures[0].address = random.percent(50) ? SELVAGE_ADDRESS_WRAP : SELVAGE_ADDRESS_CLAMP;
    const TextureImage& image = scene.textures[0];
    const int32_t near_texel = random.percent(70) ? side_texel / 4 : side_texel;
    const ScreenFace face =
        random.percent(30) ? upright_face(random, side_texel) : random_face(random, near_texel);
    if (!is_y_monotone(face.vertices)) continue;
    const double tolerances[] = {0, 0.25, 2, 100};
    const Wish wish{random.pick(tolerances), static_cast<selvage_filter>(random.in(0, 4))};
    const Plan planned = plan(scene, face, wish);
    const selvage_rect reach = reach_texel(image, face, planned);
    ASSERT_LT(reach.left, reach.right);
    ASSERT_LT(reach.top, reach.bottom);
    const std::vector<uint8_t> whole = drawn(face, planned, image, image.rgba);
    ASSERT_EQ(drawn(face, planned, image, spoiled(image, reach)), whole);
    part_of_it += reach.right - reach.left < side_texel || reach.bottom - reach.top < side_texel;
    const selvage_rect less{reach.left, reach.top, reach.right - 1, reach.bottom};
    const bool is_tight = drawn(face, planned, image, spoiled(image, less)) != whole;
    tight += is_tight;
    tight_area += is_tight && planned.options.filter == SELVAGE_FILTER_AREA;
  }
  std::cout << part_of_it << " of parts, " << tight << " tight, " << tight_area
            << " of them area\n";
  EXPECT_GT(part_of_it, 100);
  EXPECT_GT(tight, 50);
  EXPECT_GT(tight_area, 5);
}

}  // namespace
}  // namespace selvage::scene
