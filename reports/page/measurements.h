// The parts of the section on speed, from the JSON of `selvage bench`.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace selvage::reports {

// A picture with its caption, in the figures of the section.
[[nodiscard]] std::string plot_figure(const std::string& svg, const std::string& alt, int height_px,
                                      const std::string& caption);

// The exact mapper by fill, by inexact and by the fastest peer; empty where it was not measured.
[[nodiscard]] std::string standing_part(const nlohmann::ordered_json& bench);

// A plot and a table for each work item that is no adversarial one.
[[nodiscard]] std::string work_items_part(const nlohmann::ordered_json& bench);

// What near-ties everywhere cost; empty where none were measured.
[[nodiscard]] std::string adversarial_part(const nlohmann::ordered_json& bench);

// The plots of cost against one quantity; empty where none were measured.
[[nodiscard]] std::string curves_part(const nlohmann::ordered_json& bench);

// The ratios to the baseline; empty where it was not compared with one.
[[nodiscard]] std::string comparison_part(const nlohmann::ordered_json& bench);

// The item is an adversarial one, or the ordinary twin of one.
[[nodiscard]] bool is_adversarial(const nlohmann::ordered_json& bench,
                                  const nlohmann::ordered_json& work);

}  // namespace selvage::reports
