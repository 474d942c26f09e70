// Cost and error against tolerance, for tolerance_cost.gp and tolerance_error.gp.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

namespace selvage::reports {

// Files of a name and a text, from scenes.json. That of cost only where all was timed.
[[nodiscard]] std::vector<std::pair<std::string, std::string>> plot_data(
    const nlohmann::ordered_json& scenes);

}  // namespace selvage::reports
