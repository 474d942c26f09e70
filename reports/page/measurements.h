// What the plots share with the tables.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace selvage::reports {

// Wrong, missing and extra pixels per million pixels that should be covered.
[[nodiscard]] double errors_per_million(const nlohmann::ordered_json& result);

// The data of a work item's plot, as reports/plot.gp reads it: the solid fill first.
[[nodiscard]] std::string plot_data(const nlohmann::ordered_json& work);

}  // namespace selvage::reports
