#include <nlohmann/json.hpp>

#include "coverage/matrix/render.h"
#include "spec/profiles.h"

namespace selvage::coverage {
namespace {

using Json = nlohmann::ordered_json;

[[nodiscard]] std::string_view fate_name(Fate fate) {
  switch (fate) {
    case Fate::kKilled:
      return "killed";
    case Fate::kPassed:
      return "passed";
    case Fate::kNotJudged:
      return "not judged";
    default:
      return "not promised";
  }
}

[[nodiscard]] Json row_json(const Row& row) {
  Json cells = Json::object();
  for (size_t i = 0; i < row.cells.size(); ++i) {
    Json& cell = cells[std::string(spec::laws()[i].name)];
    cell["fate"] = fate_name(row.cells[i].fate);
    if (row.cells[i].fate != Fate::kNotPromised) cell["cases"] = row.cells[i].cases;
  }
  return {{"mapper", row.mapper->name},
          {"bug", row.mapper->bug},
          {"profile", spec::profile_of(row.mapper->subject.profile).name},
          {"killer", row.mapper->killer},
          {"kills", kills_of(row)},
          {"laws", cells}};
}

}  // namespace

std::string json_text(const Matrix& matrix) {
  Json json;
  json["first_seed"] = matrix.budget.first_seed;
  json["cases"] = matrix.budget.cases;
  json["killer_cases"] = matrix.budget.killer_cases;
  json["laws"] = Json::array();
  for (size_t i = 0; i < spec::laws().size(); ++i) {
    const Tally of_law = tally(matrix, i);
    json["laws"].push_back({{"law", spec::laws()[i].name},
                            {"promised", of_law.promised},
                            {"kills", of_law.kills},
                            {"sole", of_law.sole}});
  }
  json["mappers"] = Json::array();
  for (const Row& row : matrix.rows) json["mappers"].push_back(row_json(row));
  return json.dump(1) + "\n";
}

}  // namespace selvage::coverage
