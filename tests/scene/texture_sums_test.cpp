// Textures with sums: when they are made, what they cost, and that no pixel tells.
#include "scene/texture_sums.h"

#include <gtest/gtest.h>

#include <array>
#include <vector>

#include "bodies.h"
#include "scene/draw.h"

namespace selvage::scene {
namespace {

inline constexpr size_t kEnough = size_t{1} << 20;
inline constexpr double kCost_texels = kMakingSums_texels * 8 * 8;

[[nodiscard]] int64_t ticks() {
  static int64_t now_ns = 0;
  return now_ns += 10;
}

class TextureSumsTest : public testing::Test {
 protected:
  const std::vector<uint32_t> texels_ = std::vector<uint32_t>(64, 0xFF102030);
  const selvage_texture texture_{texels_.data(),      8,      8, 32, SELVAGE_RGBA8888,
                                 SELVAGE_LAYOUT_ROWS, nullptr};
  const size_t bytes_ = selvage_prepare_bytes(&texture_, SELVAGE_LAYOUT_ROWS, 1);
};

TEST_F(TextureSumsTest, AreMadeWhenAsMuchHasBeenLost) {
  TextureSums sums(kEnough, ticks);
  EXPECT_EQ(sums.of(3, texture_, kCost_texels - 1).texels, texels_.data());
  const selvage_texture plain = sums.of(3, texture_, 0.5);
  EXPECT_EQ(plain.texels, texels_.data());
  EXPECT_EQ(plain.prepared, nullptr);
  EXPECT_EQ(sums.bytes(), 0U);
  EXPECT_EQ(sums.ns(), 0);
  const selvage_texture summed = sums.of(3, texture_, 0.5);
  EXPECT_NE(summed.texels, texels_.data());
  EXPECT_NE(summed.prepared, nullptr);
  EXPECT_EQ(sums.bytes(), bytes_);
  EXPECT_EQ(sums.ns(), 10);
  const selvage_texture again = sums.of(3, texture_, 0);
  EXPECT_EQ(again.prepared, summed.prepared);
  EXPECT_EQ(sums.of(3, texture_, kCost_texels).prepared, summed.prepared);
  EXPECT_EQ(sums.bytes(), bytes_) << "made once";
  EXPECT_EQ(sums.ns(), 10);
}

TEST_F(TextureSumsTest, AreOfEachTextureByItself) {
  TextureSums sums(kEnough, ticks);
  static_cast<void>(sums.of(0, texture_, kCost_texels - 1));
  EXPECT_EQ(sums.of(1, texture_, 1).prepared, nullptr);
  EXPECT_NE(sums.of(0, texture_, 1).prepared, nullptr);
  EXPECT_EQ(sums.of(1, texture_, 1).prepared, nullptr);
  EXPECT_NE(sums.of(1, texture_, kCost_texels).prepared, nullptr);
  EXPECT_EQ(sums.bytes(), 2 * bytes_);
}

TEST_F(TextureSumsTest, AreMadeAsLongAsTheyFit) {
  for (const size_t most_bytes : {size_t{0}, bytes_ - 1, bytes_, 2 * bytes_ - 1, 2 * bytes_}) {
    TextureSums sums(most_bytes, ticks);
    for (size_t number = 0; number < 3; ++number) {
      const bool fits = (number + 1) * bytes_ <= most_bytes;
      EXPECT_EQ(sums.of(number, texture_, kCost_texels).prepared != nullptr, fits);
    }
    EXPECT_EQ(sums.bytes(), most_bytes / bytes_ * bytes_);
  }
}

// ---- In a scene
// -----------------------------------------------------------------------------------

using Pixels = std::vector<std::array<uint8_t, 4>>;

[[nodiscard]] selvage_image image_of(Pixels& pixels) {
  pixels.resize(static_cast<size_t>(kBodiesTarget.width_px) *
                static_cast<size_t>(kBodiesTarget.height_px));
  return {pixels.data(), kBodiesTarget.width_px, kBodiesTarget.height_px,
          kBodiesTarget.width_px * 4, SELVAGE_RGBA8888};
}

// Small faces, each with all of the texture.
[[nodiscard]] Scene far_ball(Shading shading) {
  Scene scene;
  TextureImage image{64, 64, {}, SELVAGE_ADDRESS_WRAP};
  for (uint32_t i = 0; i < 64 * 64 * 4; ++i) {
    image.rgba.push_back(static_cast<uint8_t>(i * 0x9E3779B1u >> 24));
  }
  scene.textures.push_back(image);
  scene.lighting.ambient = Vector3(0.5, 0.5, 0.5);
  scene.objects = {ball(24, 16)};
  scene.objects[0].materials[0].texture = 0;
  scene.objects[0].materials[0].shading = shading;
  scene.objects[0].motion.scale = 0.5;
  return scene;
}

// Straight from the texture as it is.
[[nodiscard]] Pixels plain_picture(const Scene& scene, const Drawing& drawing) {
  Pixels pixels;
  const selvage_image target = image_of(pixels);
  const TextureImage& image = scene.textures[0];
  const selvage_texture texture{image.rgba.data(),
                                image.width_texel,
                                image.height_texel,
                                4 * image.width_texel,
                                SELVAGE_RGBA8888,
                                SELVAGE_LAYOUT_ROWS,
                                nullptr};
  clear(scene, target);
  for (const Piece& piece : drawing.pieces) {
    const Plan& plan = drawing.plans[piece.face];
    const auto vertices = vertices_to_draw(drawing.view.faces[piece.face], plan);
    EXPECT_EQ(selvage_draw(&target, &piece.clip, vertices.data(), vertices.size(), &texture,
                           &plan.options),
              SELVAGE_OK);
  }
  return pixels;
}

TEST(SceneWithSums, ShowsTheSamePixels) {
  const Scene scene = far_ball(Shading::kFlat);
  const Drawing drawing = compose(scene, 0, kBodiesTarget, {}, Hidden::kScanLine);
  const Pixels plain = plain_picture(scene, drawing);
  Paints paints(scene, kLitBytes, ticks);
  int without = 0, with = 0;
  for (int frame = 0; frame < 12; ++frame) {
    ++(paints.sums().bytes() == 0 ? without : with);
    Pixels pixels;
    const selvage_image target = image_of(pixels);
    clear(scene, target);
    ASSERT_EQ(draw_pieces(scene, drawing, target, paints), SELVAGE_OK);
    ASSERT_EQ(pixels, plain) << "frame " << frame;
  }
  EXPECT_GE(without, 1);
  EXPECT_GE(with, 1);
}

// Copies in a light change with it.
TEST(SceneWithSums, MakesNoneForALitTextureOrAnotherFilter) {
  const auto bytes_after = [](Shading shading, const Wish& wish) {
    const Scene scene = far_ball(shading);
    const Drawing drawing = compose(scene, 0, kBodiesTarget, wish, Hidden::kScanLine);
    Paints paints(scene);
    Pixels pixels;
    const selvage_image target = image_of(pixels);
    for (int frame = 0; frame < 12; ++frame) {
      EXPECT_EQ(draw_pieces(scene, drawing, target, paints), SELVAGE_OK);
    }
    return paints.sums().bytes();
  };
  EXPECT_GT(bytes_after(Shading::kFlat, {}), 0U);
  EXPECT_EQ(bytes_after(Shading::kAmbient, {}), 0U);
  EXPECT_EQ(bytes_after(Shading::kFlat, {0, SELVAGE_FILTER_BILINEAR}), 0U);
}

}  // namespace
}  // namespace selvage::scene
