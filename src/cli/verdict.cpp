#include "cli/verdict.h"

#include <algorithm>
#include <cstdio>
#include <nlohmann/json.hpp>

namespace selvage::cli {
namespace {

using nlohmann::ordered_json;

[[nodiscard]] std::string row(std::string_view law, std::string_view verdict,
                              std::string_view cases, std::string_view judged,
                              std::string_view time) {
  char line[160];
  const auto width = [](std::string_view text) { return static_cast<int>(text.size()); };
  std::snprintf(line, sizeof line, "%-10.*s %-16.*s %10.*s %14.*s %10.*s\n", width(law), law.data(),
                width(verdict), verdict.data(), width(cases), cases.data(), width(judged),
                judged.data(), width(time), time.data());
  return line;
}

[[nodiscard]] std::string seconds(int64_t time_ns) {
  char text[32];
  std::snprintf(text, sizeof text, "%.2f s", static_cast<double>(time_ns) * 1e-9);
  return text;
}

[[nodiscard]] std::string_view shown_outcome(const Verdict& verdict) {
  return verdict.found.violation ? "VIOLATED" : outcome(verdict);
}

[[nodiscard]] ordered_json violation_json(const Verdict& verdict) {
  const spec::Violation& violation = *verdict.found.violation;
  ordered_json values = {{"what", violation.what},   {"u_texel", violation.u},
                         {"v_texel", violation.v},   {"allowed", violation.allowed},
                         {"drawn", violation.drawn}, {"shown_case", spec::to_hex(violation.shown)}};
  if (violation.x_px >= 0) values["pixel_px"] = {violation.x_px, violation.y_px};
  if (verdict.found.counterexample) {
    values["case"] = spec::to_hex(*verdict.found.counterexample);
    values["replay"] = replay_line(verdict);
  }
  if (!verdict.picture.empty()) values["picture"] = verdict.picture;
  return values;
}

}  // namespace

std::string_view outcome(const Verdict& verdict) {
  if (verdict.found.violation) return "violated";
  return verdict.found.judged_px == 0 ? "judged nothing" : "holds";
}

bool passed(const VerifyRun& run) {
  const auto is = [](std::string_view which) {
    return [which](const Verdict& verdict) { return outcome(verdict) == which; };
  };
  if (std::any_of(run.verdicts.begin(), run.verdicts.end(), is("violated"))) return false;
  return run.replay ? std::any_of(run.verdicts.begin(), run.verdicts.end(), is("holds"))
                    : std::all_of(run.verdicts.begin(), run.verdicts.end(), is("holds"));
}

std::string replay_line(const Verdict& verdict) {
  return "selvage verify --law " + std::string(verdict.found.law->name) + " --case " +
         spec::to_hex(*verdict.found.counterexample);
}

std::string table_header() { return row("law", "verdict", "cases", "pixels judged", "time"); }

std::string table_row(const Verdict& verdict) {
  return row(verdict.found.law->name, shown_outcome(verdict), std::to_string(verdict.found.cases),
             std::to_string(verdict.found.judged_px), seconds(verdict.time_ns));
}

std::string table_summary(const VerifyRun& run) {
  const auto count = [&](std::string_view which) {
    return std::count_if(run.verdicts.begin(), run.verdicts.end(),
                         [&](const Verdict& verdict) { return outcome(verdict) == which; });
  };
  std::string text =
      run.oracle_missing ? "ORACLE is not in this build, which found no OpenCV.\n" : "";
  text +=
      std::to_string(count("holds")) + " of " + std::to_string(run.verdicts.size()) + " laws hold";
  if (const auto n = count("violated")) text += ", " + std::to_string(n) + " violated";
  if (const auto n = count("judged nothing")) {
    text += ", " + std::to_string(n) + " judged nothing";
    text += run.replay ? " in this case" : ", which shows nothing and counts as a failure";
  }
  text += ".\n";
  for (const std::string& law : run.not_promised) text += "not promised: " + law + "\n";
  return text;
}

std::string verdict_json(const VerifyRun& run) {
  ordered_json values = {
      {"subject", run.subject}, {"profile", run.profile}, {"passed", passed(run)}};
  if (!run.replay) values["seed"] = run.seed;
  values["laws"] = ordered_json::array();
  for (const Verdict& verdict : run.verdicts) {
    ordered_json law = {{"law", verdict.found.law->name},
                        {"verdict", outcome(verdict)},
                        {"cases", verdict.found.cases},
                        {"judged_px", verdict.found.judged_px},
                        {"time_ns", verdict.time_ns}};
    if (verdict.found.violation) law["violation"] = violation_json(verdict);
    values["laws"].push_back(std::move(law));
  }
  if (!run.not_promised.empty()) values["not_promised"] = run.not_promised;
  return values.dump(2, ' ', false, ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace selvage::cli
