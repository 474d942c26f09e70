// From a scene to its pixels.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <vector>

#include "bodies.h"
#include "chequered_texture.h"
#include "plane_face.h"
#include "scene/draw.h"

namespace selvage::scene {
namespace {

using Pixel = std::array<uint8_t, 4>;

[[nodiscard]] std::vector<Pixel> picture(const Scene& scene, const Wish& wish, Hidden way) {
  std::vector<Pixel> pixels(static_cast<size_t>(kBodiesTarget.width_px) *
                            static_cast<size_t>(kBodiesTarget.height_px));
  const selvage_image image{pixels.data(), kBodiesTarget.width_px, kBodiesTarget.height_px,
                            kBodiesTarget.width_px * 4, SELVAGE_RGBA8888};
  EXPECT_EQ(draw(scene, compose(scene, 0, kBodiesTarget, wish, way), image), SELVAGE_OK);
  return pixels;
}

// A ball of textured faces and a cube that cuts through it.
[[nodiscard]] Scene crossing_bodies() {
  Scene scene;
  scene.background = {1, 2, 3};
  scene.lighting = {Vector3(0.25, 0.25, 0.25), {{Vector3(1, 1, 1), Vector3(0.5, 0.5, 0.5)}}};
  scene.textures.push_back(chequered(64));
  scene.objects = {ball(9, 6), cube()};
  scene.objects[0].materials[0].texture = 0;
  scene.objects[0].motion.angle_deg = 20;
  scene.objects[1].motion.scale = 0.7;
  scene.objects[1].motion.axis = {1, 2, 3};
  scene.objects[1].motion.angle_deg = 50;
  scene.objects[1].materials[0].colour = {250, 120, 10};
  return scene;
}

TEST(Draw, ShowsAFaceTowardsTheLampInItsColour) {
  Scene scene;
  scene.background = {1, 2, 3};
  scene.lighting = {Vector3(0.2, 0.2, 0.2), {{Vector3(0, 0, 1), Vector3(0.4, 0.4, 0.4)}}};
  scene.objects = {cube()};
  scene.objects[0].materials[0].colour = {250, 100, 0};
  const std::vector<Pixel> pixels = picture(scene, {}, Hidden::kScanLine);
  EXPECT_EQ(pixels[0], (Pixel{1, 2, 3, 255}));
  EXPECT_EQ(pixels[36 * 96 + 48], (Pixel{150, 60, 0, 255}));
}

// What scan lines show is drawn by the same plans: each pixel is that of some face drawn whole.
TEST(Draw, ScanLinesChangeNoPixelOfWhatTheyShow) {
  const Scene scene = crossing_bodies();
  const Drawing scanned = compose(scene, 0, kBodiesTarget, {}, Hidden::kScanLine);
  const std::vector<Pixel> pixels = picture(scene, {}, Hidden::kScanLine);
  std::vector<std::vector<Pixel>> alone;
  for (size_t face = 0; face < scanned.view.faces.size(); ++face) {
    Drawing one = scanned;
    one.pieces = {{face, {0, 0, kBodiesTarget.width_px, kBodiesTarget.height_px}}};
    alone.emplace_back(pixels.size());
    const selvage_image image{alone.back().data(), kBodiesTarget.width_px, kBodiesTarget.height_px,
                              kBodiesTarget.width_px * 4, SELVAGE_RGBA8888};
    ASSERT_EQ(draw(scene, one, image), SELVAGE_OK);
  }
  std::vector<bool> is_shown(pixels.size());
  for (const Piece& piece : scanned.pieces) {
    for (int32_t y = piece.clip.top; y < piece.clip.bottom; ++y) {
      for (int32_t x = piece.clip.left; x < piece.clip.right; ++x) {
        const size_t i = static_cast<size_t>(y * kBodiesTarget.width_px + x);
        if (alone[piece.face][i] == Pixel{1, 2, 3, 255}) continue;
        EXPECT_EQ(pixels[i], alone[piece.face][i]) << x << ", " << y;
        is_shown[i] = true;
      }
    }
  }
  EXPECT_GT(std::count(is_shown.begin(), is_shown.end(), true), 800);
}

// Copies that are lit where they are reached, and thrown away at once, draw as whole ones do.
TEST(Draw, FewCopiesOfLitTexturesDrawTheSame) {
  const Scene scene = crossing_bodies();
  for (const Hidden way : {Hidden::kPainter, Hidden::kScanLine}) {
    const Drawing drawing = compose(scene, 0, kBodiesTarget, {}, way);
    std::vector<Pixel> few(static_cast<size_t>(kBodiesTarget.width_px * kBodiesTarget.height_px));
    const selvage_image image{few.data(), kBodiesTarget.width_px, kBodiesTarget.height_px,
                              kBodiesTarget.width_px * 4, SELVAGE_RGBA8888};
    clear(scene, image);
    Paints one_copy(scene, 0);
    ASSERT_EQ(draw_pieces(scene, drawing, image, one_copy), SELVAGE_OK);
    EXPECT_EQ(few, picture(scene, {}, way));
    EXPECT_GT(one_copy.lit_texels(), 0);
  }
}

TEST(Draw, PainterAgreesOnOneConvexBody) {
  Scene scene = crossing_bodies();
  scene.objects.pop_back();
  EXPECT_EQ(picture(scene, {}, Hidden::kPainter), picture(scene, {}, Hidden::kScanLine));
  scene = crossing_bodies();  // and need not where bodies cut through each other
  EXPECT_NE(picture(scene, {}, Hidden::kPainter), picture(scene, {}, Hidden::kScanLine));
}

TEST(Draw, ToleranceChangesTexelsButNoOutline) {
  const Scene scene = crossing_bodies();
  const auto exact = picture(scene, {0, SELVAGE_FILTER_NEAREST}, Hidden::kScanLine);
  const auto rough = picture(scene, {64, SELVAGE_FILTER_NEAREST}, Hidden::kScanLine);
  int differ = 0;
  for (size_t i = 0; i < exact.size(); ++i) {
    EXPECT_EQ(exact[i] == (Pixel{1, 2, 3, 255}), rough[i] == (Pixel{1, 2, 3, 255}));
    differ += exact[i] != rough[i];
  }
  EXPECT_GT(differ, 0);
}

TEST(Draw, AnEmptyViewIsTheBackground) {
  Scene scene = crossing_bodies();
  scene.camera.target = {0, 0, 10};
  for (const Pixel& pixel : picture(scene, {}, Hidden::kScanLine)) {
    EXPECT_EQ(pixel, (Pixel{1, 2, 3, 255}));
  }
}

}  // namespace
}  // namespace selvage::scene
