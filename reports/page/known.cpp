#include "reports/page/known.h"

#include <algorithm>

#include "cli/error.h"

namespace selvage::reports {
namespace {

using json = nlohmann::ordered_json;

// The cases of one row's findings.
[[nodiscard]] std::vector<cli::KnownCase> cases_of(const json& row, const std::string& id) {
  std::vector<cli::KnownCase> cases;
  const json laws = row.value("laws", json::object());
  for (const auto& [law, finding] : laws.items()) {
    if (!finding.contains("case")) continue;
    const auto found = spec::from_hex(finding["case"].get<std::string>());
    if (!found) throw cli::UserError("the finding of " + id + ", " + law + ", has no case");
    cases.push_back({law, *found});
  }
  return cases;
}

}  // namespace

std::vector<cli::KnownCase> known_cases(const json& findings, const std::string& id,
                                        const std::vector<cli::KnownCase>& corpus) {
  std::vector<cli::KnownCase> known = cases_of(findings.value(id, json::object()), id);
  const auto own = known;
  const auto take = [&](const std::vector<cli::KnownCase>& others) {
    for (const cli::KnownCase& other : others) {
      const auto is_same = [&](const cli::KnownCase& one) { return one.law == other.law; };
      if (std::ranges::none_of(own, is_same)) known.push_back(other);
    }
  };
  for (const auto& [other, row] : findings.items()) {
    if (other != id) take(cases_of(row, other));
  }
  take(corpus);
  return known;
}

}  // namespace selvage::reports
