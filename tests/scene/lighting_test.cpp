// The light that faces reflect.
#include <gtest/gtest.h>

#include <cmath>

#include "bodies.h"
#include "scene/look.h"

namespace selvage::scene {
namespace {

TEST(Lighting, FollowsLambert) {
  Lighting lighting{Vector3(0.2, 0.2, 0.2), {{Vector3(0, 0, 2), Vector3(0.8, 0.4, 0)}}};
  const auto level = [&](Shading shading, const Vector3& normal) {
    return reflected(lighting, shading, normal);
  };
  const Vector3 slanted(0, std::sqrt(0.75), 0.5);
  EXPECT_EQ(level(Shading::kFlat, {0, 0, 1}), (Light{255, 255, 255}));
  EXPECT_EQ(level(Shading::kAmbient, {0, 0, 1}), (Light{51, 51, 51}));
  EXPECT_EQ(level(Shading::kDiffuse, {0, 0, 1}), (Light{255, 153, 51}));
  EXPECT_EQ(level(Shading::kDiffuse, {0, 0, -1}), (Light{51, 51, 51}));
  EXPECT_EQ(level(Shading::kDiffuse, slanted), (Light{153, 102, 51}));
}

// The normal turns with the object, and a face that is seen from behind shows the light on that
// side.
TEST(Lighting, FallsOnTheSideThatIsSeen) {
  Scene scene;
  scene.objects.push_back(cube());
  scene.lighting = {Vector3::Zero(), {{Vector3(0, 0, 1), Vector3::Ones()}}};
  scene.objects[0].faces = {scene.objects[0].faces[0]};  // z = -1, towards -z
  scene.objects[0].materials[0].colour = {200, 100, 50};
  scene.objects[0].two_sided = true;
  const auto colour = [&](double angle_deg) {
    scene.objects[0].motion.angle_deg = angle_deg;
    return look(scene, 0, Size{320, 200}).faces.at(0).paint.colour;
  };
  EXPECT_EQ(colour(0), (Colour{200, 100, 50}));    // its inside
  EXPECT_EQ(colour(180), (Colour{200, 100, 50}));  // its outside
  EXPECT_EQ(colour(60), (Colour{100, 50, 25}));
  scene.lighting.lamps[0].towards = {0, 0, -1};
  EXPECT_EQ(colour(0), (Colour{0, 0, 0}));
  EXPECT_EQ(colour(180), (Colour{0, 0, 0}));
}

TEST(Lighting, MultipliesToTheNearest) {
  for (int channel = 0; channel < 256; ++channel) {
    for (int level = 0; level < 256; ++level) {
      EXPECT_EQ(lit(static_cast<uint8_t>(channel), static_cast<uint8_t>(level)),
                static_cast<int>(std::floor(channel * level / 255.0 + 0.5)));
    }
  }
}

}  // namespace
}  // namespace selvage::scene
