// A scene drawn within each tolerance, with the filter left to the planner and with nearest:
// pictures written, every pixel judged, and what there is to time.
#pragma once

#include <array>
#include <filesystem>
#include <functional>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "reports/bench/statistics.h"
#include "reports/scenes/cost.h"
#include "reports/scenes/judge.h"
#include "reports/scenes/shipped.h"

namespace selvage::reports {

inline constexpr std::array<double, 5> kTolerances_texel{0, 1.0 / 16, 0.25, 1, 4};

// What one filter and tolerance came to.
struct Trial {
  std::string filter;  // "auto" or "nearest"
  double tolerance_texel = 0;
  std::string overlay_file;
  Verdict verdict;
  std::array<size_t, kChoices> choice_faces{};  // a face of several counts for each
  uint64_t different_px = 0;                    // whose colour is not that of the exact picture
  int32_t largest_level = 0;                    // of 255, by the worst channel
  std::unique_ptr<Calls> calls;
  std::optional<Spread> ns_per_px, textured_ns_per_px;  // empty until timed
};

struct Study {
  const Shipped* shipped;
  scene::Scene what;  // stays where it is: the trials' calls read its textures
  scene::Size size;
  scene::Counts counts;
  double tolerance_texel = 0;              // the scene's own
  uint64_t shown_px = 0, faces_shown = 0;  // the others that face the eye are hidden
  std::vector<Trial> trials;
};

// Writes the picture and the overlays into the folder. tick is called before each trial.
[[nodiscard]] std::unique_ptr<Study> study(const Shipped& shipped,
                                           const std::filesystem::path& folder,
                                           const scene::Size& size,
                                           const std::filesystem::path& output,
                                           const std::function<void()>& tick);

// The broken promises of all trials, a line each.
[[nodiscard]] std::vector<std::string> breaches(const std::vector<std::unique_ptr<Study>>& studies);

// "0", "1/16", "1/4", "1", "4".
[[nodiscard]] std::string tolerance_name(double tolerance_texel);

// What scenes.json holds of it.
[[nodiscard]] nlohmann::ordered_json json_of(const Study& study);

}  // namespace selvage::reports
