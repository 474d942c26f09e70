#include "cli/demo_state.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iterator>
#include <numbers>

#include "cli/job.h"
#include "spec/profiles.h"

namespace selvage::cli {
namespace {

using scene::Vector3;

[[nodiscard]] Eigen::Quaterniond rotation(const Vector3& axis, double angle_deg) {
  return Eigen::Quaterniond(
      Eigen::AngleAxisd(angle_deg * (std::numbers::pi / 180), axis.stableNormalized()));
}

[[nodiscard]] std::optional<selvage_filter> next(const std::optional<selvage_filter>& filter) {
  if (!filter) return SELVAGE_FILTER_NEAREST;
  switch (*filter) {
    case SELVAGE_FILTER_NEAREST:
      return SELVAGE_FILTER_FOUR;
    case SELVAGE_FILTER_FOUR:
      return SELVAGE_FILTER_BILINEAR;
    case SELVAGE_FILTER_BILINEAR:
      return SELVAGE_FILTER_AREA;
    default:
      return std::nullopt;
  }
}

[[nodiscard]] selvage_profile next(selvage_profile mapper) {
  switch (mapper) {
    case SELVAGE_PROFILE_EXACT:
      return SELVAGE_PROFILE_ABRASH56;
    case SELVAGE_PROFILE_ABRASH56:
      return SELVAGE_PROFILE_ABRASH57;
    default:
      return SELVAGE_PROFILE_EXACT;
  }
}

// A key that makes a number more or less.
struct Step {
  DemoKey key;
  int32_t DemoState::*number;
  int32_t by, most;
};
constexpr Step kSteps[] = {{DemoKey::kFaster, &DemoState::speed_quarters, 1, kMostSpeed_quarters},
                           {DemoKey::kSlower, &DemoState::speed_quarters, -1, kMostSpeed_quarters},
                           {DemoKey::kLeft, &DemoState::right_steps, -1, kMostMove_steps},
                           {DemoKey::kRight, &DemoState::right_steps, 1, kMostMove_steps},
                           {DemoKey::kUp, &DemoState::up_steps, 1, kMostMove_steps},
                           {DemoKey::kDown, &DemoState::up_steps, -1, kMostMove_steps},
                           {DemoKey::kNearer, &DemoState::near_steps, 1, kMostMove_steps},
                           {DemoKey::kFarther, &DemoState::near_steps, -1, kMostMove_steps}};

// Whether the key is one of these.
[[nodiscard]] bool take_step(DemoState& state, DemoKey key) {
  const Step* const step = std::ranges::find(kSteps, key, &Step::key);
  if (step == std::end(kSteps)) return false;
  int32_t& number = state.*step->number;
  number = std::clamp(number + step->by, -step->most, step->most);
  return true;
}

void turn_about(DemoState& state, const Vector3& axis, const char* name) {
  state.axis = axis;
  state.axis_name = name;
}

void flip_axis(DemoState& state) {
  state.axis = -state.axis;
  const bool flipped = state.axis_name.front() == '-';
  state.axis_name = flipped ? state.axis_name.substr(1) : "-" + state.axis_name;
}

[[nodiscard]] std::string wished_filter_name(const std::optional<selvage_filter>& filter) {
  return filter ? std::string(filter_name(*filter)) : "auto";
}

}  // namespace

DemoState demo_start(const scene::Scene& scene) {
  const scene::Motion& motion = scene.objects.front().motion;
  DemoState state;
  state.turn = rotation(motion.axis, motion.angle_deg);
  state.axis = motion.axis.stableNormalized();
  state.spin_deg = motion.spin_deg != 0 ? motion.spin_deg : kUsualSpin_deg;
  return state;
}

void press(DemoState& state, DemoKey key) {
  if (take_step(state, key)) return;
  switch (key) {
    case DemoKey::kAxisX:
      return turn_about(state, Vector3::UnitX(), "x");
    case DemoKey::kAxisY:
      return turn_about(state, Vector3::UnitY(), "y");
    case DemoKey::kAxisZ:
      return turn_about(state, Vector3::UnitZ(), "z");
    case DemoKey::kFlipAxis:
      return flip_axis(state);
    case DemoKey::kFilter:
      state.filter = next(state.filter);
      return;
    case DemoKey::kMapper:
      state.mapper = next(state.mapper);
      return;
    case DemoKey::kDifference:
      state.difference = !state.difference;
      return;
    case DemoKey::kReport:
      state.report = true;
      return;
    case DemoKey::kHelp:
      state.help = !state.help;
      return;
    case DemoKey::kQuit:
      state.quit = true;
      return;
    default:
      return;
  }
}

void advance(DemoState& state, double step_s) {
  const double scene_step_s = step_s * state.speed_quarters / 4;
  if (scene_step_s == 0) return;  // what stands still stays the same to the bit
  state.time_s += scene_step_s;
  state.turn = (rotation(state.axis, state.spin_deg * scene_step_s) * state.turn).normalized();
}

scene::Scene posed(const scene::Scene& scene, const DemoState& state) {
  scene::Scene now = scene;
  pose(scene, state, now);
  return now;
}

void pose(const scene::Scene& scene, const DemoState& state, scene::Scene& now) {
  scene::Motion& ball = now.objects.front().motion;
  ball = scene.objects.front().motion;
  const Eigen::AngleAxisd turn(state.turn);
  ball.axis = turn.axis();
  ball.angle_deg = turn.angle() * (180 / std::numbers::pi);
  ball.spin_deg = 0;
  scene::Camera& camera = now.camera;
  camera = scene.camera;
  const Vector3 back = camera.position - camera.target;
  const Vector3 right = camera.up.stableNormalized().cross(back).normalized();
  const Vector3 up = back.cross(right).normalized();
  // The scene goes to the right where the camera goes to the left.
  const Vector3 aside = (right * state.right_steps + up * state.up_steps) * (back.norm() / 16);
  camera.target -= aside;
  camera.position = camera.target + back * std::exp2(-state.near_steps / 4.0);
}

std::string demo_settings(const DemoState& state) {
  char speed[16];
  std::snprintf(speed, sizeof speed, "%.2f", state.speed_quarters / 4.0);
  return "mapper " + std::string(spec::profile_of(state.mapper).name) + ", filter " +
         wished_filter_name(state.filter) + ", axis " + state.axis_name + ", speed " + speed;
}

}  // namespace selvage::cli
