#include "cli/verdict_json.h"

#include <nlohmann/json.hpp>

#include "cli/case_json.h"
#include "cli/json_text.h"
#include "selvage.h"
#include "spec/sample_place.h"

namespace selvage::cli {
namespace {

using nlohmann::ordered_json;

// Where the model takes the texel of the pixel, and how far off the one that was drawn is.
void add_coordinates(const spec::Violation& violation, ordered_json* values) {
  if (!violation.u.empty()) {
    (*values)["u_texel"] = violation.u;
    (*values)["v_texel"] = violation.v;
  }
  if (violation.off_by) {
    (*values)["off_by_texel"] = {{"u", violation.off_by->u_texel},
                                 {"v", violation.off_by->v_texel}};
  }
  if (violation.off_by_px) (*values)["off_by_px"] = *violation.off_by_px;
}

[[nodiscard]] ordered_json violation_json(const VerifyRun& run, const Verdict& verdict) {
  const spec::Violation& violation = *verdict.found.violation;
  ordered_json values = {{"what", violation.what},
                         {"allowed", violation.allowed},
                         {"drawn", violation.drawn},
                         {"shown", case_json(violation.shown)},
                         {"shown_case", spec::to_hex(violation.shown)}};
  add_coordinates(violation, &values);
  if (violation.x_px >= 0) {
    values["pixel_px"] = {violation.x_px, violation.y_px};
    if (violation.scene.empty())
      values["sample"] = spec::describe_sample(violation.shown, violation.x_px, violation.y_px);
  }
  if (!violation.scene.empty()) values["scene"] = violation.scene;
  if (violation.is_of_call) values["of_call"] = true;
  if (verdict.found.hung) values["hung"] = true;
  if (!run.replay) values["case_number"] = verdict.found.failed_case;
  if (!run.replay) values["found_by"] = found_by(verdict);
  if (!run.replay) {
    const spec::Replays& replays = verdict.found.replays;
    values["smallest"] = verdict.found.is_smallest;
    values["replays"] = {{"tried", replays.tried}, {"failed", replays.failed}};
  }
  if (const auto notes = notes_on(verdict); !notes.empty()) values["notes"] = notes;
  if (verdict.found.counterexample) {
    values["case"] = spec::to_hex(*verdict.found.counterexample);
    values["replay"] = replay_line(run, verdict);
  }
  if (const auto& found = verdict.found.found_case; found && !run.replay) {
    values["found_case"] = spec::to_hex(*found);
    values["found_replay"] = replay_line(run, verdict, *found);
  }
  if (!verdict.picture.empty()) values["picture"] = verdict.picture;
  return values;
}

[[nodiscard]] ordered_json hunted_json(const spec::Hunted& hunted) {
  ordered_json values = {{"cases", hunted.cases}};
  if (hunted.best) {
    values["best"] = {{"share", hunted.best->share}, {"closeness", hunted.best->closeness}};
  }
  return values;
}

[[nodiscard]] ordered_json law_json(const VerifyRun& run, const Verdict& verdict) {
  const spec::LawVerdict& found = verdict.found;
  ordered_json law = {{"law", found.law->name},
                      {"verdict", outcome(verdict)},
                      {"cases", found.cases},
                      {"judged_px", found.judged_px},
                      {"time_ns", verdict.time_ns}};
  if (found.margin) {
    law["nearest"] = {{"measured", found.margin->measured}, {"bound", found.margin->bound}};
  }
  if (!verdict.in_part.empty()) law["in_part"] = verdict.in_part;
  if (!verdict.not_promised.empty()) law["not_promised"] = verdict.not_promised;
  if (!found.not_claimed.empty()) law["not_claimed"] = found.not_claimed;
  if (found.hunted.cases > 0) law["hunted"] = hunted_json(found.hunted);
  if (verdict.known.tried > 0) {
    law["known"] = {{"tried", verdict.known.tried}, {"not_judged", verdict.known.not_judged}};
  }
  if (found.violation) law["violation"] = violation_json(run, verdict);
  return law;
}

}  // namespace

std::string verdict_json(const VerifyRun& run) {
  ordered_json values = {{"selvage", selvage_version()},
                         {"subject", run.subject},
                         {"profile", run.profile},
                         {"accuracy_fx16", run.accuracy_fx16},
                         {"coverage_accuracy_fx16", run.coverage_accuracy_fx16},
                         {"passed", passed(run)}};
  values["arguments"] = run.arguments;
  if (!run.replay) {
    values["seed"] = run.seed;
    values["cases"] = run.cases;
    values["hunted"] = run.hunted;
    values["known_cases"] = run.known_cases;
    values["known_of_others"] = run.known_of_others;
  }
  if (run.shard.count > 1) values["shard"] = {{"index", run.shard.index}, {"of", run.shard.count}};
  values["oracle_missing"] = run.oracle_missing;
  values["laws"] = ordered_json::array();
  for (const Verdict& verdict : run.verdicts) values["laws"].push_back(law_json(run, verdict));
  values["not_promised"] = ordered_json::array();
  for (const NotPromised& law : run.not_promised) {
    values["not_promised"].push_back({{"law", law.law}, {"why", law.why}});
  }
  values["not_exported"] = ordered_json::array();
  for (const auto& [function, law] : run.not_exported) {
    ordered_json& missing = values["not_exported"].emplace_back();
    missing["function"] = function;
    if (!law.empty()) missing["law"] = law;
  }
  return json_text(values);
}

}  // namespace selvage::cli
