// The data of the plots of speed, for plane.gp and curve.gp.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace selvage::reports {

struct PlotFile {
  std::string name;  // "W1.plane.dat", "scale.curve.dat": the second word is the script's
  std::string text;
};

// Of all work items, without the adversarial ones, and of all curves in the JSON of `selvage
// bench`.
[[nodiscard]] std::vector<PlotFile> plot_files(const nlohmann::ordered_json& bench);

// Wrong texels or filtered colours, and missing, extra and twice drawn pixels, per million covered
// pixels.
[[nodiscard]] double errors_per_million(const nlohmann::ordered_json& result);

// What a subject measured on a work item or a curve's point; null where it was not.
[[nodiscard]] const nlohmann::ordered_json* result_of(const nlohmann::ordered_json& item,
                                                      const std::string& subject);

// The same for people: "63.5 ppm", "2.28 %".
[[nodiscard]] std::string error_share(const nlohmann::ordered_json& result);

// It was measured, and its picture judged.
[[nodiscard]] bool has_errors(const nlohmann::ordered_json& result);

}  // namespace selvage::reports
