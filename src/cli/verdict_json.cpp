#include "cli/verdict_json.h"

#include <concepts>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "cli/error.h"
#include "cli/json_text.h"
#include "selvage.h"
#include "spec/sample_place.h"
#include "testbed/printable.h"

namespace selvage::cli {
namespace {

using nlohmann::ordered_json;

using Counts = std::map<std::string, uint64_t>;

// What JSON can have in its place (a fraction, a sign, more digits) must not be converted.
template <std::integral Integer = uint64_t>
[[nodiscard]] Integer whole(const ordered_json& values, const std::string& key) {
  const ordered_json& value = values.at(key);
  if (value.is_number_unsigned()) {
    if (const auto number = value.get<uint64_t>(); std::in_range<Integer>(number)) {
      return static_cast<Integer>(number);
    }
  } else if (value.is_number_integer()) {
    if (const auto number = value.get<int64_t>(); std::in_range<Integer>(number)) {
      return static_cast<Integer>(number);
    }
  }
  constexpr size_t kMostShownBytes = 40;
  using Limits = std::numeric_limits<Integer>;
  throw UserError("'" + key + "' is " + testbed::printable(value.dump(), kMostShownBytes) +
                  "; a whole number from " + std::to_string(Limits::min()) + " to " +
                  std::to_string(Limits::max()) + " is right");
}

[[nodiscard]] Counts read_counts(const ordered_json& values) {
  Counts counts;
  for (const auto& item : values.items()) counts[item.key()] = whole(values, item.key());
  return counts;
}

[[nodiscard]] Shard read_shard(const ordered_json& values) {
  const Shard shard{whole(values, "index"), whole(values, "of")};
  if (shard.index >= 1 && shard.index <= shard.count) return shard;
  const std::string of = "/" + std::to_string(shard.count);
  throw UserError("there is no shard " + std::to_string(shard.index) + of +
                  (shard.count > 0 ? "; 1" + of + " to " + std::to_string(shard.count) + of + " are"
                                   : "; 1/N to N/N are"));
}

[[nodiscard]] ordered_json violation_json(const VerifyRun& run, const Verdict& verdict) {
  const spec::Violation& violation = *verdict.found.violation;
  ordered_json values = {{"what", violation.what},   {"u_texel", violation.u},
                         {"v_texel", violation.v},   {"allowed", violation.allowed},
                         {"drawn", violation.drawn}, {"shown_case", spec::to_hex(violation.shown)}};
  if (violation.x_px >= 0) {
    values["pixel_px"] = {violation.x_px, violation.y_px};
    values["sample"] = spec::describe_sample(violation.shown, violation.x_px, violation.y_px);
  }
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

[[nodiscard]] spec::Hunted read_hunted(const ordered_json& values) {
  spec::Hunted hunted{.cases = whole(values, "cases")};
  if (values.contains("best")) {
    hunted.best = {values["best"].at("share"), values["best"].at("closeness")};
  }
  return hunted;
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
  if (!found.not_claimed.empty()) law["not_claimed"] = found.not_claimed;
  if (found.hunted.cases > 0) law["hunted"] = hunted_json(found.hunted);
  if (verdict.known.tried > 0) {
    law["known"] = {{"tried", verdict.known.tried}, {"not_judged", verdict.known.not_judged}};
  }
  if (found.violation) law["violation"] = violation_json(run, verdict);
  return law;
}

[[nodiscard]] spec::Case read_case(const ordered_json& hex) {
  const auto digits = hex.get<std::string>();
  const std::optional<spec::Case> c = spec::from_hex(digits);
  if (!c) throw UserError("a case is no hexadecimal number");
  if (spec::to_hex(*c) != digits) {
    throw UserError("the " + std::to_string(digits.size()) +
                    " digits of a case are no whole one as verify prints it, but one that was cut "
                    "off, lengthened or changed");
  }
  return *c;
}

[[nodiscard]] spec::Violation read_violation(const ordered_json& values, std::string law) {
  spec::Violation violation{.law = std::move(law),
                            .what = values.at("what"),
                            .u = values.at("u_texel"),
                            .v = values.at("v_texel"),
                            .allowed = values.at("allowed"),
                            .drawn = values.at("drawn"),
                            .shown = read_case(values.at("shown_case"))};
  if (values.contains("pixel_px")) {
    const ordered_json& pixel = values["pixel_px"];
    violation.x_px = whole<int32_t>({{"x_px", pixel.at(0)}}, "x_px");
    violation.y_px = whole<int32_t>({{"y_px", pixel.at(1)}}, "y_px");
  }
  return violation;
}

[[nodiscard]] Verdict read_law(const ordered_json& values) {
  const std::string name = values.at("law");
  Verdict verdict;
  spec::LawVerdict& found = verdict.found;
  found.law = spec::find_law(name);
  if (found.law == nullptr) throw UserError("this program knows no law '" + name + "'");
  found.cases = whole(values, "cases");
  found.judged_px = whole(values, "judged_px");
  verdict.time_ns = whole<int64_t>(values, "time_ns");
  verdict.lacked_time = values.at("verdict") == "not judged";
  if (values.contains("nearest")) {
    found.margin = {values["nearest"].at("measured"), values["nearest"].at("bound")};
  }
  if (values.contains("not_claimed")) found.not_claimed = read_counts(values["not_claimed"]);
  if (values.contains("hunted")) found.hunted = read_hunted(values["hunted"]);
  if (values.contains("known")) {
    verdict.known = {whole(values["known"], "tried"),
                     read_counts(values["known"].at("not_judged"))};
  }
  if (!values.contains("violation")) return verdict;
  const ordered_json& violation = values["violation"];
  found.violation = read_violation(violation, name);
  found.counterexample = read_case(violation.at("case"));
  found.failed_case = whole(violation, "case_number");
  found.is_smallest = violation.at("smallest");
  found.replays = {whole(violation.at("replays"), "tried"),
                   whole(violation.at("replays"), "failed")};
  const std::string found_by = violation.at("found_by");
  verdict.from_corpus = found_by == "corpus";
  found.hunted.found = found_by == "hunt";
  verdict.picture = violation.value("picture", "");
  return verdict;
}

[[nodiscard]] VerifyRun read_run(const ordered_json& values) {
  if (values.at("selvage") != selvage_version()) {
    throw UserError("it is of version " + values.at("selvage").get<std::string>() +
                    ", this program of " + selvage_version());
  }
  if (!values.contains("seed")) throw UserError("it is of a replay, which is of no parts");
  VerifyRun run{.subject = testbed::printable(values.at("subject").get<std::string>()),
                .profile = testbed::printable(values.at("profile").get<std::string>()),
                .seed = whole(values, "seed"),
                .verdicts = {}};
  run.cases = whole(values, "cases");
  run.hunted = whole(values, "hunted");
  run.known_cases = whole(values, "known_cases");
  run.known_of_others = read_counts(values.at("known_of_others"));
  run.arguments = values.at("arguments");
  run.oracle_missing = values.at("oracle_missing");
  if (values.contains("shard")) run.shard = read_shard(values["shard"]);
  for (const ordered_json& law : values.at("laws")) run.verdicts.push_back(read_law(law));
  if (run.verdicts.empty()) throw UserError("it has no verdict of any law, and so shows nothing");
  for (const ordered_json& law : values.at("not_promised")) {
    run.not_promised.push_back({law.at("law"), law.at("why")});
  }
  for (const ordered_json& missing : values.at("not_exported")) {
    run.not_exported.push_back({missing.at("function"), missing.at("law")});
  }
  return run;
}

}  // namespace

std::string verdict_json(const VerifyRun& run) {
  ordered_json values = {{"selvage", selvage_version()},
                         {"subject", run.subject},
                         {"profile", run.profile},
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
    values["not_exported"].push_back({{"function", function}, {"law", law}});
  }
  return json_text(values);
}

VerifyRun read_verdict(const std::string& json) {
  try {
    return read_run(ordered_json::parse(json));
  } catch (const ordered_json::exception& error) {
    throw UserError("it is not what 'selvage verify --json' prints: " + std::string(error.what()));
  }
}

}  // namespace selvage::cli
