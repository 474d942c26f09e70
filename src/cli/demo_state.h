// What `selvage demo` shows, and what keys do to it: plain values, no window, no clock.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "scene/scene.h"
#include "scene/vectors.h"
#include "selvage.h"

namespace selvage::cli {

enum class DemoKey {
  kFaster,
  kSlower,
  kAxisX,
  kAxisY,
  kAxisZ,
  kFlipAxis,
  kLeft,
  kRight,
  kUp,
  kDown,
  kNearer,
  kFarther,
  kFilter,
  kMapper,
  kDifference,
  kReport,
  kHelp,
  kQuit
};

// The ball is the scene's first object: it turns as the keys say. The others keep to the scene.
struct DemoState {
  Eigen::Quaterniond turn = Eigen::Quaterniond::Identity();  // of the ball, in the world
  scene::Vector3 axis = scene::Vector3::UnitY();             // of what it turns on by
  std::string axis_name = "own";
  double spin_deg = 0;         // a second, at speed 1
  int32_t speed_quarters = 4;  // of the whole scene's time
  double time_s = 0;           // the scene's
  int32_t right_steps = 0, up_steps = 0, near_steps = 0;
  std::optional<selvage_filter> filter;  // empty: what each face needs
  selvage_profile mapper = SELVAGE_PROFILE_EXACT;
  bool difference = false, help = true;
  bool report = false, quit = false;  // asked for; whoever answers a report resets it
};

inline constexpr int32_t kMostSpeed_quarters = 40, kMostMove_steps = 16;
inline constexpr double kUsualSpin_deg = 40;  // for a ball whose scene does not turn it

[[nodiscard]] DemoState demo_start(const scene::Scene& scene);
void press(DemoState& state, DemoKey key);
void advance(DemoState& state, double step_s);

// The scene as the state has it at state.time_s: the ball turned, the camera moved. A step to the
// side is 1/16 of the distance from the camera to its target; four steps nearer halve that.
[[nodiscard]] scene::Scene posed(const scene::Scene& scene, const DemoState& state);

// The same, where `now` is a copy of the scene, however posed: no texture is copied again.
void pose(const scene::Scene& scene, const DemoState& state, scene::Scene& now);

// "mapper exact, filter auto, axis own, speed 1.00"
[[nodiscard]] std::string demo_settings(const DemoState& state);

}  // namespace selvage::cli
