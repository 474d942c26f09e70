// Which scenes of the stability table are shown as pictures.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace selvage::reports {

struct WorstCase {
  std::string family, arithmetic;
  std::string command;  // that measures the scene alone
  std::string picture;  // its file's name
  uint64_t largest_texel = 0;
};

// Of each family in `selvage stability --json` the worst scene of an arithmetic that can draw it:
// not one without perspective where there is perspective, nor one of whole pixels.
[[nodiscard]] std::vector<WorstCase> worst_cases(const nlohmann::ordered_json& run);

// A line each: the picture's name, a tab, the arguments of `selvage` that draw it.
[[nodiscard]] std::string worst_case_lines(const nlohmann::ordered_json& run);

}  // namespace selvage::reports
