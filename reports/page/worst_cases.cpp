#include "reports/page/worst_cases.h"

#include <tuple>

namespace selvage::reports {

namespace {

using json = nlohmann::ordered_json;

// Whole-pixel mappers promise a bound and are measured with what rounding the scene does to it, so
// their worst scenes show the rounding.
bool can_draw(const json& arithmetic, const json& cell, const json& family) {
  if (!cell.at("kept").get<bool>()) return true;  // a broken promise is always shown
  if (arithmetic.at("promise") == "bound") return false;
  return !arithmetic.at("affine_only").get<bool>() || !family.at("perspective").get<bool>();
}

}  // namespace

std::vector<WorstCase> worst_cases(const json& run) {
  std::vector<WorstCase> worst_of_families;
  for (const json& family : run.at("families")) {
    const json* found = nullptr;
    const auto key = [](const json& cell) {
      const json& worst = cell.at("worst");
      return std::tuple(
          worst.at("largest_texel").get<uint64_t>(), worst.at("wrong_share").get<double>(),
          worst.at("missing_px").get<uint64_t>() + worst.at("extra_px").get<uint64_t>());
    };
    for (size_t i = 0; i < run.at("arithmetics").size(); ++i) {
      const json& cell = family.at("cells")[i];
      if (!cell.contains("worst") || !can_draw(run["arithmetics"][i], cell, family)) continue;
      if (found == nullptr || key(cell) > key(*found)) found = &cell;
    }
    if (found == nullptr) continue;
    const auto name = family.at("family").get<std::string>();
    worst_of_families.push_back({name, found->at("arithmetic").get<std::string>(),
                                 found->at("worst").at("command").get<std::string>(),
                                 "stability-" + name + ".png",
                                 found->at("worst").at("largest_texel").get<uint64_t>()});
  }
  return worst_of_families;
}

std::string worst_case_lines(const json& run) {
  const std::string program = "selvage ";
  std::string lines;
  for (const WorstCase& worst : worst_cases(run))
    lines += worst.picture + "\t" + worst.command.substr(program.size()) + "\n";
  return lines;
}

}  // namespace selvage::reports
