// The verdicts of single subjects, put together.
#include <sstream>

#include "cli/error.h"
#include "cli/file.h"
#include "reports/page/again.h"
#include "reports/page/matrix.h"

namespace selvage::reports {

namespace {

using json = nlohmann::ordered_json;
namespace fs = std::filesystem;

json cell_of_law(const json& law, const std::string& id) {
  json cell = law;
  cell.erase("time_ns");
  if (cell.at("verdict") != "violated") return cell;
  cell["page"] = "matrix/" + id + "-" + cell.at("law").get<std::string>() + ".html";
  json& violation = cell["violation"];
  if (violation.contains("picture"))
    violation["picture"] = fs::path(violation["picture"].get<std::string>()).filename().string();
  return cell;
}

// The cell of a law in a verdict, or null where the verdict says nothing of it.
json cell_of(const MatrixRow& row, const std::string& name) {
  for (const json& law : row.verdict.at("laws")) {
    if (law.at("law") == name) return cell_of_law(law, row.id);
  }
  for (const json& law : row.verdict.at("not_promised")) {
    if (law.at("law") == name)
      return {{"law", name}, {"verdict", "not promised"}, {"why", law.at("why")}};
  }
  return nullptr;
}

// What was found is about the case that it was found on, and that one is tried first; `varies`:
// what is shown is not the mapper's alone, so that it may look right.
enum class Standing { kNone, kShown, kStale };
Standing standing_of(const json& cell, const json& finding) {
  if (cell.at("verdict") == "not judged") return Standing::kNone;  // the time was over
  const bool violated = cell.at("verdict") == "violated";
  if (finding.is_null() || !finding.contains("case") || finding.value("varies", false)) {
    return violated && !finding.is_null() ? Standing::kShown : Standing::kNone;
  }
  return violated && cell.at("violation").value("found_by", "") == "corpus" ? Standing::kShown
                                                                            : Standing::kStale;
}

void add_finding(const json& known, json* cell, json* subject) {
  const auto law = cell->at("law").get<std::string>();
  const json findings = known.value("laws", json::object());
  const json finding = findings.value(law, json());
  const Standing standing = standing_of(*cell, finding);
  if (standing == Standing::kShown) (*cell)["finding"] = finding;
  if (standing == Standing::kStale) (*subject)["stale"].push_back(law);
}

// Why a law says nothing of a profile, by the profile's name: what `selvage laws --json` notes.
json silent_of(const json& law) {
  json silent = json::object();
  const json promises = law.value("profiles", json::object());
  for (const auto& [profile, promise] : promises.items()) {
    if (promise.at("standing") == "says nothing of it") silent[profile] = promise.value("note", "");
  }
  return silent;
}

json subject_of(const MatrixRow& row, const json& laws, const json& known) {
  json subject = {{"id", row.id}, {"group", row.group}};
  if (known.contains("convention")) subject["convention"] = known["convention"];
  if (known.contains("examined")) subject["examined"] = known["examined"];
  if (row.verdict.is_null()) {
    subject["error"] = row.error;
    return subject;
  }
  for (const char* key : {"subject", "profile", "passed", "arguments"})
    subject[key] = row.verdict.at(key);
  subject["cells"] = json::array();
  for (const json& law : laws) {
    const auto name = law.at("law").get<std::string>();
    json cell = cell_of(row, name);
    if (cell.is_null()) continue;
    add_finding(known, &cell, &subject);
    subject["cells"].push_back(std::move(cell));
  }
  return subject;
}

json read_verdict(const fs::path& path) {
  return cli::about(path.string(), [&] {
    try {
      return json::parse(cli::read_text_file(path));
    } catch (const json::exception& error) {
      throw cli::UserError(std::string("not JSON: ") + error.what());
    }
  });
}

}  // namespace

std::vector<MatrixRow> read_rows(const fs::path& folder) {
  std::vector<MatrixRow> rows;
  std::istringstream lines(cli::read_text_file(folder / "rows.tsv"));
  for (std::string line; std::getline(lines, line);) {
    const size_t tab = line.find('\t');
    if (tab == std::string::npos) throw cli::UserError("rows.tsv: no tab in '" + line + "'");
    MatrixRow row{line.substr(0, tab), line.substr(tab + 1), nullptr, ""};
    const fs::path verdict = folder / (row.id + ".json");
    const fs::path second = folder / (row.id + ".again.json");
    if (!fs::exists(verdict)) {
      row.error = cli::read_text_file(folder / (row.id + ".error"));
      rows.push_back(std::move(row));
      continue;
    }
    row.verdict = read_verdict(verdict);
    if (fs::exists(second)) row.verdict = with_second(row.verdict, read_verdict(second));
    rows.push_back(std::move(row));
  }
  return rows;
}

json matrix_of(const std::vector<MatrixRow>& rows, const json& laws, const json& findings) {
  json matrix = json::object();
  for (const MatrixRow& row : rows) {
    if (row.verdict.is_null()) continue;
    for (const char* key : {"selvage", "seed", "cases"}) matrix[key] = row.verdict.at(key);
    break;
  }
  matrix["laws"] = json::array();
  for (const json& law : laws)
    matrix["laws"].push_back(
        {{"law", law.at("law")}, {"statement", law.at("statement")}, {"silent", silent_of(law)}});
  matrix["subjects"] = json::array();
  for (const MatrixRow& row : rows)
    matrix["subjects"].push_back(subject_of(row, laws, findings.value(row.id, json::object())));
  return matrix;
}

std::vector<std::string> open_questions(const json& matrix) {
  std::vector<std::string> open;
  for (const json& subject : matrix.at("subjects")) {
    const auto ask = [&](const json& law, const char* what) {
      open.push_back(subject.at("id").get<std::string>() + ": " + law.get<std::string>() + ": " +
                     what);
    };
    for (const json& law : subject.value("stale", json::array())) {
      ask(law, "the finding is stale: its case holds");
    }
    if (subject.at("group") != "peers") continue;
    for (const json& cell : subject.value("cells", json::array())) {
      const bool is_open = cell.at("verdict") == "violated" && !cell.contains("finding");
      if (is_open) ask(cell.at("law"), "the violation is unexamined");
    }
  }
  return open;
}

bool ours_hold(const json& matrix) {
  for (const json& subject : matrix.at("subjects")) {
    if (subject.at("group") == "ours" && !subject.value("passed", false)) return false;
  }
  return true;
}

}  // namespace selvage::reports
