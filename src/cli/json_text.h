// JSON as the program prints it.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace selvage::cli {

// On lines of its own, the last ended; what is not UTF-8 is replaced.
[[nodiscard]] inline std::string json_text(const nlohmann::ordered_json& values, int indent = 2) {
  return values.dump(indent, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace selvage::cli
