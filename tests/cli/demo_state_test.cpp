#include "cli/demo_state.h"

#include <gtest/gtest.h>

#include <cmath>

#include "demo_support.h"

namespace selvage::cli::test {
namespace {

using scene::Vector3;

// Rounding alone: some 2^-53 for each of a few hundred operations.
constexpr double kRounding = 1e-9;

[[nodiscard]] Vector3 on_ball(const scene::Scene& scene, const DemoState& state,
                              const Vector3& point) {
  return placed(posed(scene, state).objects.front().motion, state.time_s) * point;
}

// Where a point of the world is for the eye: x right, y down, z forward.
[[nodiscard]] Vector3 seen(const scene::Scene& scene, const DemoState& state,
                           const Vector3& point) {
  return world_to_eye(posed(scene, state).camera) * point;
}

TEST(DemoState, TurnsAsTheSceneDoesWhileNoKeyIsPressed) {
  const scene::Scene scene = station();
  DemoState state = demo_start(scene);
  for (int frame = 0; frame < 50; ++frame) {
    for (const Vector3& point : {Vector3(1, 0, 0), Vector3(0, 1, 0), Vector3(0, 0, 1)}) {
      const Vector3 expected = placed(scene.objects.front().motion, state.time_s) * point;
      EXPECT_LT((on_ball(scene, state, point) - expected).norm(), kRounding) << frame;
    }
    advance(state, 0.04);
  }
  EXPECT_NEAR(state.time_s, 2, kRounding);
}

TEST(DemoState, TurnsAboutTheAxisOfTheKey) {
  struct {
    DemoKey key;
    Vector3 axis, from, to;
  } const kTurns[] = {
      {DemoKey::kAxisX, Vector3::UnitX(), Vector3::UnitY(), Vector3::UnitZ()},
      {DemoKey::kAxisY, Vector3::UnitY(), Vector3::UnitZ(), Vector3::UnitX()},
      {DemoKey::kAxisZ, Vector3::UnitZ(), Vector3::UnitX(), Vector3::UnitY()},
  };
  scene::Scene scene = station();
  scene.objects.front().motion = {};
  scene.objects.front().motion.spin_deg = 90;
  for (const auto& turn : kTurns) {
    DemoState state = demo_start(scene);
    press(state, turn.key);
    EXPECT_LT((on_ball(scene, state, turn.from) - turn.from).norm(), kRounding) << "a jump";
    advance(state, 1);
    EXPECT_LT((on_ball(scene, state, turn.from) - turn.to).norm(), kRounding);
    EXPECT_LT((on_ball(scene, state, turn.axis) - turn.axis).norm(), kRounding);
    press(state, DemoKey::kFlipAxis);
    advance(state, 2);
    EXPECT_LT((on_ball(scene, state, turn.from) + turn.to).norm(), kRounding);
  }
}

TEST(DemoState, StandsStillToTheBitAtSpeedNothing) {
  const scene::Scene scene = station();
  DemoState state = demo_start(scene);
  advance(state, 0.3);
  for (int i = 0; i < 4; ++i) press(state, DemoKey::kSlower);
  const DemoState before = state;
  advance(state, 100);
  EXPECT_EQ(state.time_s, before.time_s);
  EXPECT_EQ(state.turn.coeffs(), before.turn.coeffs());
  press(state, DemoKey::kSlower);
  advance(state, 1);
  EXPECT_LT(state.time_s, before.time_s);
}

TEST(DemoState, SpeedHasEnds) {
  DemoState state = demo_start(station());
  for (int i = 0; i < 100; ++i) press(state, DemoKey::kFaster);
  EXPECT_EQ(state.speed_quarters, kMostSpeed_quarters);
  for (int i = 0; i < 200; ++i) press(state, DemoKey::kSlower);
  EXPECT_EQ(state.speed_quarters, -kMostSpeed_quarters);
}

TEST(DemoState, MovesWhatIsSeen) {
  const scene::Scene scene = station();
  const Vector3 target = scene.camera.target;
  const double distance = (scene.camera.position - target).norm();
  const auto after = [&](DemoKey key, int times) {
    DemoState state = demo_start(scene);
    for (int i = 0; i < times; ++i) press(state, key);
    return seen(scene, state, target);
  };
  const auto expect_at = [&](const Vector3& at, double x, double y, double z) {
    EXPECT_LT((at - distance * Vector3(x, y, z)).norm(), kRounding) << at.transpose();
  };
  expect_at(after(DemoKey::kRight, 1), 1 / 16., 0, 1);
  expect_at(after(DemoKey::kLeft, 2), -2 / 16., 0, 1);
  expect_at(after(DemoKey::kUp, 1), 0, -1 / 16., 1);
  expect_at(after(DemoKey::kDown, 1), 0, 1 / 16., 1);
  expect_at(after(DemoKey::kNearer, 4), 0, 0, 0.5);
  expect_at(after(DemoKey::kFarther, 4), 0, 0, 2);
  expect_at(after(DemoKey::kRight, 1000), kMostMove_steps / 16., 0, 1);
}

TEST(DemoState, PosesAgainFromTheStart) {
  const scene::Scene scene = station();
  scene::Scene now = scene;
  DemoState state = demo_start(scene);
  for (const DemoKey key : {DemoKey::kUp, DemoKey::kNearer, DemoKey::kAxisX, DemoKey::kLeft}) {
    press(state, key);
    advance(state, 0.3);
    pose(scene, state, now);
    const scene::Scene anew = posed(scene, state);
    EXPECT_EQ(now.camera.position, anew.camera.position);
    EXPECT_EQ(now.camera.target, anew.camera.target);
    EXPECT_EQ(now.objects[0].motion.axis, anew.objects[0].motion.axis);
    EXPECT_EQ(now.objects[0].motion.angle_deg, anew.objects[0].motion.angle_deg);
  }
}

TEST(DemoState, GoesRoundTheFiltersAndMappers) {
  DemoState state = demo_start(station());
  EXPECT_EQ(demo_settings(state), "mapper exact, filter auto, axis own, speed 1.00");
  for (const char* filter : {"nearest", "four", "bilinear", "area", "auto"}) {
    press(state, DemoKey::kFilter);
    EXPECT_NE(demo_settings(state).find(std::string("filter ") + filter + ","), std::string::npos);
  }
  for (const char* mapper : {"abrash56", "abrash57", "exact"}) {
    press(state, DemoKey::kMapper);
    EXPECT_EQ(demo_settings(state).find(std::string("mapper ") + mapper + ","), 0u);
  }
  press(state, DemoKey::kAxisZ);
  press(state, DemoKey::kFlipAxis);
  press(state, DemoKey::kSlower);
  EXPECT_EQ(demo_settings(state), "mapper exact, filter auto, axis -z, speed 0.75");
  press(state, DemoKey::kFlipAxis);
  EXPECT_EQ(state.axis_name, "z");
}

TEST(DemoState, SwitchesAndAsks) {
  DemoState state = demo_start(station());
  EXPECT_TRUE(state.help);
  press(state, DemoKey::kHelp);
  press(state, DemoKey::kDifference);
  EXPECT_FALSE(state.help);
  EXPECT_TRUE(state.difference);
  press(state, DemoKey::kDifference);
  EXPECT_FALSE(state.difference);
  EXPECT_FALSE(state.report);
  press(state, DemoKey::kReport);
  EXPECT_TRUE(state.report);
  EXPECT_FALSE(state.quit);
  press(state, DemoKey::kQuit);
  EXPECT_TRUE(state.quit);
}

}  // namespace
}  // namespace selvage::cli::test
