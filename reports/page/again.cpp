#include "reports/page/again.h"

#include <set>

#include "cli/error.h"

namespace selvage::reports {
namespace {

using json = nlohmann::ordered_json;

[[nodiscard]] std::set<std::string> laws_kept(const MatrixRow& row, const json& findings) {
  std::set<std::string> kept;
  if (row.verdict.is_null()) return kept;
  const json examined = findings.value(row.id, json::object()).value("laws", json::object());
  for (const json& law : row.verdict.at("laws")) {
    const auto name = law.at("law").get<std::string>();
    if (law.at("verdict") != "violated" && !examined.contains(name)) kept.insert(name);
  }
  return kept;
}

[[nodiscard]] std::vector<cli::KnownCase> newly_found(const MatrixRow& row) {
  std::vector<cli::KnownCase> found;
  if (row.verdict.is_null()) return found;
  for (const json& law : row.verdict.at("laws")) {
    const json violation = law.value("violation", json::object());
    if (!violation.contains("case") || violation.value("found_by", "") == "corpus") continue;
    const auto c = spec::from_hex(violation["case"].get<std::string>());
    if (!c) throw cli::UserError(row.id + ".json: the case of a violation is none");
    found.push_back({law.at("law").get<std::string>(), *c});
  }
  return found;
}

}  // namespace

std::vector<cli::KnownCase> to_try_again(const std::vector<MatrixRow>& rows, const json& findings,
                                         const std::string& id) {
  std::set<std::string> kept;
  for (const MatrixRow& row : rows) {
    if (row.id == id) kept = laws_kept(row, findings);
  }
  std::vector<cli::KnownCase> again;
  for (const MatrixRow& row : rows) {
    if (row.id == id) continue;
    for (cli::KnownCase& found : newly_found(row)) {
      if (kept.contains(found.law)) again.push_back(std::move(found));
    }
  }
  return again;
}

json with_second(json first, const json& second) {
  for (const json& again : second.at("laws")) {
    if (again.at("verdict") != "violated") continue;
    for (json& law : first.at("laws")) {
      if (law.at("law") == again.at("law")) law = again;
    }
    first["passed"] = false;
  }
  return first;
}

}  // namespace selvage::reports
