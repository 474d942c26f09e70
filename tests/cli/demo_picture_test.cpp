#include "cli/demo_picture.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "cli/bitmap_font.h"
#include "cli/profile_drawing.h"
#include "demo_support.h"

namespace selvage::cli::test {
namespace {

constexpr scene::Size kSize{320, 240};

[[nodiscard]] DemoState quiet_start(const scene::Scene& scene) {
  DemoState state = demo_start(scene);
  state.help = false;
  return state;
}

[[nodiscard]] bool is_black(const Raster& picture) {
  for (int32_t y = 0; y < picture.height_px; ++y) {
    for (int32_t x = 0; x < picture.width_px; ++x) {
      if (picture.at(x, y) != Colour{0, 0, 0, 255}) return false;
    }
  }
  return true;
}

TEST(DemoPicture, IsTheScenesWithTextUponIt) {
  const scene::Scene scene = station();
  DemoState state = quiet_start(scene);
  advance(state, 0.5);
  const DemoPicture picture = demo_picture(scene, state, kSize);
  const ProfileDrawing drawn = draw_by_profile(posed(scene, state), state.time_s, kSize,
                                               {scene.tolerance_texel, {}}, SELVAGE_PROFILE_EXACT);
  const Raster plain = to_raster(drawn.picture);
  EXPECT_EQ(above_text(picture.raster), above_text(plain));
  EXPECT_NE(picture.raster, plain);
  EXPECT_GT(picture.faces, 20u);
  EXPECT_EQ(demo_picture(scene, state, kSize).raster, picture.raster);
}

// Lit copies and sums of earlier poses change no pixel of later ones.
TEST(DemoPicture, IsTheSameFromPaintsThatAreKept) {
  const scene::Scene scene = station();
  DemoState state = quiet_start(scene);
  scene::Scene now = scene;
  scene::Paints paints(now, scene::kLitBytes);
  for (int frame = 0; frame < 6; ++frame) {
    if (frame == 3) press(state, DemoKey::kFilter);
    if (frame == 4) press(state, DemoKey::kMapper);
    if (frame == 5) press(state, DemoKey::kDifference);
    advance(state, 0.5);
    pose(scene, state, now);
    EXPECT_EQ(posed_picture(now, state, kSize, paints).raster,
              demo_picture(scene, state, kSize).raster)
        << "frame " << frame;
  }
  EXPECT_GT(paints.lit_texels(), 0);
}

TEST(DemoPicture, EverySettingShows) {
  const scene::Scene scene = station();
  const DemoState state = quiet_start(scene);
  const Raster before = demo_picture(scene, state, kSize).raster;
  for (const DemoKey key :
       {DemoKey::kLeft, DemoKey::kUp, DemoKey::kNearer, DemoKey::kFarther, DemoKey::kFilter,
        DemoKey::kMapper, DemoKey::kDifference, DemoKey::kHelp}) {
    DemoState pressed = state;
    press(pressed, key);
    EXPECT_NE(above_text(demo_picture(scene, pressed, kSize).raster), above_text(before))
        << "key " << static_cast<int>(key);
  }
}

TEST(DemoPicture, TheExactMapperDiffersFromItselfNowhere) {
  scene::Scene scene = station();
  scene.tolerance_texel = 0;
  DemoState state = quiet_start(scene);
  state.difference = true;
  const DemoPicture picture = demo_picture(scene, state, kSize);
  EXPECT_EQ(picture.differing_px, 0);
  EXPECT_TRUE(is_black(above_text(picture.raster)));
}

TEST(DemoPicture, ToleranceAndHistoricMappersDiffer) {
  scene::Scene scene = station();
  scene.tolerance_texel = 4;
  DemoState state = quiet_start(scene);
  state.difference = true;
  state.filter = SELVAGE_FILTER_NEAREST;
  const int64_t by_tolerance_px = demo_picture(scene, state, kSize).differing_px;
  EXPECT_GT(by_tolerance_px, 0);
  for (int i = 0; i < 2; ++i) {
    press(state, DemoKey::kMapper);
    const DemoPicture picture = demo_picture(scene, state, kSize);
    EXPECT_GT(picture.differing_px, by_tolerance_px);
    EXPECT_FALSE(is_black(above_text(picture.raster)));
    EXPECT_NE(demo_counts(state, picture).find(" px differ"), std::string::npos);
  }
}

// The ball is convex: whichever way its faces are rounded, no row of it has a hole.
TEST(ProfileDrawing, LeavesNoGapsBetweenFaces) {
  scene::Scene scene = station();
  scene.objects.resize(1);
  for (const scene::Size size : {kSize, scene::Size{40, 30}}) {
    for (const selvage_profile profile :
         {SELVAGE_PROFILE_EXACT, SELVAGE_PROFILE_ABRASH56, SELVAGE_PROFILE_ABRASH57}) {
      for (int frame = 0; frame < 20; ++frame) {
        const Raster picture =
            to_raster(draw_by_profile(scene, frame / 4., size, {}, profile).picture);
        const scene::Colour& background = scene.background;
        const Colour blank{background.red, background.green, background.blue, background.alpha};
        for (int32_t y = 0; y < size.height_px; ++y) {
          int32_t borders = 0;
          for (int32_t x = 1; x < size.width_px; ++x) {
            borders += (picture.at(x, y) == blank) != (picture.at(x - 1, y) == blank);
          }
          EXPECT_TRUE(borders == 0 || borders == 2)
              << "profile " << static_cast<int>(profile) << " frame " << frame << " row " << y
              << " borders " << borders;
        }
      }
    }
  }
}

// Faces of a pixel or two, seen from every side: whatever they are rounded to is an outline that
// the profiles take, for draw_by_profile throws where they do not.
TEST(ProfileDrawing, NoFaceIsRefused) {
  const scene::Scene scene = station();
  for (int frame = 0; frame < 200; ++frame) {
    for (const selvage_profile profile :
         {SELVAGE_PROFILE_ABRASH56, SELVAGE_PROFILE_ABRASH57, SELVAGE_PROFILE_DKIT}) {
      EXPECT_NO_THROW((void)draw_by_profile(scene, frame / 8., {40, 30}, {}, profile)) << frame;
    }
  }
}

TEST(BitmapFont, DrawsWhatItIsToldAndNothingOutside) {
  Raster picture = filled(6, 9, {0, 0, 0});
  draw_text(picture, 0, 0, 1, "l", {255, 255, 255});
  int lit = 0;
  for (int32_t y = 0; y < 9; ++y) {
    for (int32_t x = 0; x < 6; ++x) {
      const bool expected = (x == 0 && y >= 1 && y <= 7) || (y == 7 && x <= 4);
      EXPECT_EQ(picture.at(x, y) == (Colour{255, 255, 255}), expected) << x << ' ' << y;
      lit += expected;
    }
  }
  EXPECT_EQ(lit, 11);
  Raster capital = filled(6, 9, {0, 0, 0});
  draw_text(capital, 0, 0, 1, "L", {255, 255, 255});
  EXPECT_EQ(capital, picture);
  Raster beyond = filled(6, 9, {0, 0, 0});
  draw_text(beyond, -96, -3, 2, "LLLLLLLLLLLLLLLLLLLLLLL", {255, 255, 255});
  shade(beyond, -5, -5, 100, 100);
  EXPECT_NE(beyond, filled(6, 9, {0, 0, 0}));
}

TEST(BitmapFont, TellsItsCharactersApart) {
  const std::string all = "ABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789.,:+-/%()=' \x7f";
  std::vector<std::vector<uint8_t>> pictures;
  for (const char character : all) {
    Raster picture = filled(6, 9, {0, 0, 0});
    draw_text(picture, 0, 0, 1, std::string(1, character), {255, 255, 255});
    pictures.push_back(picture.rgba);
  }
  std::ranges::sort(pictures);
  EXPECT_EQ(std::ranges::adjacent_find(pictures), pictures.end());
}

}  // namespace
}  // namespace selvage::cli::test
