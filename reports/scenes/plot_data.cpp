#include "reports/scenes/plot_data.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace selvage::reports {
namespace {

using json = nlohmann::ordered_json;

// The place of no error on the axis of log10: below all that can be measured.
inline constexpr double kPlaceOfZero = -7;

// A scene with a filter: a line of the plots.
struct Series {
  std::string name;
  std::vector<const json*> trials;  // by tolerance
};

[[nodiscard]] std::vector<Series> series_of(const json& scenes) {
  std::vector<Series> all;
  for (const json& one : scenes.at("scenes")) {
    for (const json& trial : one.at("trials")) {
      const std::string name =
          one.at("id").get<std::string>() + ", " + trial.at("filter").get<std::string>();
      if (all.empty() || all.back().name != name) all.push_back({name, {}});
      all.back().trials.push_back(&trial);
    }
  }
  return all;
}

[[nodiscard]] std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "\t%.6g", value);
  return text;
}

[[nodiscard]] std::string place(double value) {
  return number(value > 0 ? std::max(std::log10(value), kPlaceOfZero) : kPlaceOfZero);
}

using Cells = std::string (*)(const json& trial);

// First the names, each above its cells; then a line a tolerance: its name, its place on the axis.
[[nodiscard]] std::string table(const std::vector<Series>& all, size_t cells, Cells cells_of) {
  std::string text = "\t";
  for (const Series& series : all) text += "\t" + series.name + std::string(cells - 1, '\t');
  text += "\n";
  for (size_t i = 0; i < all.front().trials.size(); ++i) {
    const json& first = *all.front().trials[i];
    text += first.at("tolerance").get<std::string>() + number(static_cast<double>(i));
    for (const Series& series : all) text += cells_of(*series.trials[i]);
    text += "\n";
  }
  return text;
}

[[nodiscard]] std::string cost_cells(const json& trial) {
  std::string cells;
  for (const char* key : {"median", "lower_quartile", "upper_quartile"})
    cells += number(trial.at("textured_ns_per_px").at(key).get<double>());
  return cells;
}

[[nodiscard]] std::string error_cells(const json& trial) {
  return place(trial.at("largest_error_texel").get<double>()) +
         place(trial.at("mean_error_texel").get<double>());
}

}  // namespace

std::vector<std::pair<std::string, std::string>> plot_data(const json& scenes) {
  const std::vector<Series> all = series_of(scenes);
  std::vector<std::pair<std::string, std::string>> files{
      {"scenes-error.tolerance_error.dat", table(all, 2, error_cells)}};
  const bool timed = std::ranges::all_of(all, [](const Series& series) {
    return std::ranges::none_of(
        series.trials, [](const json* trial) { return trial->at("textured_ns_per_px").is_null(); });
  });
  if (timed) files.emplace_back("scenes-cost.tolerance_cost.dat", table(all, 3, cost_cells));
  return files;
}

}  // namespace selvage::reports
