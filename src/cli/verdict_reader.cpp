// Reads what verdict_json has written.
#include <algorithm>
#include <concepts>
#include <cstdint>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "cli/error.h"
#include "cli/located_json.h"
#include "cli/verdict_json.h"
#include "selvage.h"
#include "testbed/printable.h"

namespace selvage::cli {
namespace {

using Counts = std::map<std::string, uint64_t>;

constexpr const char* kNeeded = "what 'selvage verify --json' prints is needed";

// What JSON can have in its place (a fraction, a sign, more digits) must not be converted.
template <std::integral Integer = uint64_t>
[[nodiscard]] Integer whole(const JsonNode& node) {
  const nlohmann::json& value = node.value();
  if (value.is_number_unsigned()) {
    if (const auto number = value.get<uint64_t>(); std::in_range<Integer>(number)) {
      return static_cast<Integer>(number);
    }
  } else if (value.is_number_integer()) {
    if (const auto number = value.get<int64_t>(); std::in_range<Integer>(number)) {
      return static_cast<Integer>(number);
    }
  }
  using Limits = std::numeric_limits<Integer>;
  node.fail_for("a whole number from " + std::to_string(Limits::min()) + " to " +
                std::to_string(Limits::max()));
}

// A file's text may be shown on a terminal.
[[nodiscard]] std::string read_text(const JsonNode& node) {
  return testbed::printable(node.text());
}

[[nodiscard]] int32_t read_accuracy(const JsonNode& node) {
  const auto accuracy_fx16 = whole<int32_t>(node);
  if (accuracy_fx16 >= 0) return accuracy_fx16;
  node.fail("no accuracy is below 0, which is exact");
}

[[nodiscard]] Counts read_counts(const JsonNode& node) {
  Counts counts;
  for (const auto& [what, count] : node.members()) counts[testbed::printable(what)] = whole(count);
  return counts;
}

[[nodiscard]] Shard read_shard(const JsonNode& node) {
  const Shard shard{whole(node.at("index")), whole(node.at("of"))};
  if (shard.index >= 1 && shard.index <= shard.count) return shard;
  const std::string of = "/" + std::to_string(shard.count);
  node.fail("there is no shard " + std::to_string(shard.index) + of +
            (shard.count > 0 ? "; 1" + of + " to " + std::to_string(shard.count) + of + " are"
                             : "; 1/N to N/N are"));
}

[[nodiscard]] spec::Hunted read_hunted(const JsonNode& node) {
  spec::Hunted hunted{.cases = whole(node.at("cases"))};
  if (node.has("best")) {
    const JsonNode best = node.at("best");
    hunted.best = {best.at("share").number(), best.at("closeness").number()};
  }
  return hunted;
}

[[nodiscard]] spec::Margin read_margin(const JsonNode& node) {
  const JsonNode measured = node.at("measured"), bound = node.at("bound");
  if (measured.number() < 0) measured.fail("no error is below 0");
  if (!(bound.number() > 0)) bound.fail("a bound is above 0");
  return {measured.number(), bound.number()};
}

[[nodiscard]] spec::Case read_case(const JsonNode& node) {
  const std::string& digits = node.text();
  const std::optional<spec::Case> c = spec::from_hex(digits);
  if (!c) node.fail("a case's hexadecimal digits are needed, as verify prints them");
  if (spec::to_hex(*c) != digits) {
    node.fail("the " + std::to_string(digits.size()) +
              " digits of a case are no whole one as verify prints it, but one that was cut off, "
              "lengthened or changed");
  }
  return *c;
}

void read_pixel(const JsonNode& node, spec::Violation* violation) {
  const std::vector<JsonNode> pixel = node.elements("number");
  if (pixel.size() != 2) node.fail_for("[x, y] in pixels");
  violation->x_px = whole<int32_t>(pixel[0]);
  violation->y_px = whole<int32_t>(pixel[1]);
}

[[nodiscard]] spec::Violation read_violation(const JsonNode& node, std::string law) {
  spec::Violation violation{.law = std::move(law),
                            .what = read_text(node.at("what")),
                            .allowed = read_text(node.at("allowed")),
                            .drawn = read_text(node.at("drawn")),
                            .shown = read_case(node.at("shown_case")),
                            .is_of_call = node.has("of_call") && node.at("of_call").boolean()};
  if (node.has("u_texel")) {
    violation.u = read_text(node.at("u_texel"));
    violation.v = read_text(node.at("v_texel"));
  }
  if (node.has("off_by_texel")) {
    const JsonNode off_by = node.at("off_by_texel");
    violation.off_by = {off_by.at("u").number(), off_by.at("v").number()};
  }
  if (node.has("off_by_px")) violation.off_by_px = node.at("off_by_px").number();
  if (node.has("scene")) violation.scene = read_text(node.at("scene"));
  if (node.has("pixel_px")) read_pixel(node.at("pixel_px"), &violation);
  return violation;
}

void read_failure(const JsonNode& node, Verdict* verdict) {
  spec::LawVerdict& found = verdict->found;
  found.violation = read_violation(node, std::string(found.law->name));
  found.counterexample = read_case(node.at("case"));
  if (node.has("found_case")) found.found_case = read_case(node.at("found_case"));
  found.hung = node.has("hung") && node.at("hung").boolean();
  found.failed_case = whole(node.at("case_number"));
  found.is_smallest = node.at("smallest").boolean();
  const JsonNode replays = node.at("replays");
  found.replays = {whole(replays.at("tried")), whole(replays.at("failed"))};
  const std::string& found_by = node.at("found_by").text();
  verdict->from_corpus = found_by == "corpus";
  found.hunted.found = found_by == "hunt";
  if (node.has("picture")) verdict->picture = read_text(node.at("picture"));
}

[[nodiscard]] Verdict read_law(const JsonNode& node) {
  const JsonNode name = node.at("law");
  Verdict verdict;
  spec::LawVerdict& found = verdict.found;
  found.law = spec::find_law(name.text());
  if (found.law == nullptr) {
    name.fail("this program knows no law '" + testbed::printable(name.text()) +
              "'; 'selvage laws' lists them");
  }
  found.cases = whole(node.at("cases"));
  found.judged_px = whole(node.at("judged_px"));
  verdict.time_ns = whole<int64_t>(node.at("time_ns"));
  const JsonNode told = node.at("verdict");
  verdict.lacked_time = told.text() == "not judged";
  if (node.has("nearest")) found.margin = read_margin(node.at("nearest"));
  if (node.has("not_claimed")) found.not_claimed = read_counts(node.at("not_claimed"));
  if (node.has("hunted")) found.hunted = read_hunted(node.at("hunted"));
  if (node.has("known")) {
    const JsonNode known = node.at("known");
    verdict.known = {whole(known.at("tried")), read_counts(known.at("not_judged"))};
  }
  if (node.has("violation")) read_failure(node.at("violation"), &verdict);
  if (node.has("in_part")) verdict.in_part = read_text(node.at("in_part"));
  if (node.has("not_promised")) verdict.not_promised = read_text(node.at("not_promised"));
  if (told.text() != outcome(verdict)) {
    told.fail("it is '" + read_text(told) + "', but what follows is of one that is '" +
              std::string(outcome(verdict)) + "'");
  }
  return verdict;
}

[[nodiscard]] VerifyRun read_beginning(const JsonNode& root) {
  if (!root.has("selvage")) root.fail(std::string("'selvage' is missing; ") + kNeeded);
  const JsonNode version = root.at("selvage");
  if (version.text() != selvage_version()) {
    version.fail("it is of version " + testbed::printable(version.text()) + ", this program of " +
                 selvage_version());
  }
  if (!root.has("seed")) root.fail("there is no 'seed': a replay has none, and is of no parts");
  VerifyRun run{.subject = read_text(root.at("subject")),
                .profile = read_text(root.at("profile")),
                .accuracy_fx16 = read_accuracy(root.at("accuracy_fx16")),
                .coverage_accuracy_fx16 = read_accuracy(root.at("coverage_accuracy_fx16")),
                .seed = whole(root.at("seed")),
                .verdicts = {}};
  run.cases = whole(root.at("cases"));
  run.hunted = whole(root.at("hunted"));
  run.known_cases = whole(root.at("known_cases"));
  run.known_of_others = read_counts(root.at("known_of_others"));
  run.arguments = read_text(root.at("arguments"));
  run.oracle_missing = root.at("oracle_missing").boolean();
  if (root.has("shard")) run.shard = read_shard(root.at("shard"));
  return run;
}

[[nodiscard]] VerifyRun read_run(const JsonNode& root) {
  VerifyRun run = read_beginning(root);
  for (const JsonNode& law : root.at("not_promised").elements("law")) {
    run.not_promised.push_back({read_text(law.at("law")), read_text(law.at("why"))});
  }
  const JsonNode laws = root.at("laws");
  for (const JsonNode& law : laws.elements("law")) {
    Verdict verdict = read_law(law);
    const auto is_it = [&](const Verdict& other) { return other.found.law == verdict.found.law; };
    if (std::ranges::any_of(run.verdicts, is_it)) law.fail("the law was told of before");
    run.verdicts.push_back(std::move(verdict));
  }
  if (run.verdicts.empty()) laws.fail("it has no verdict of any law, and so shows nothing");
  for (const JsonNode& missing : root.at("not_exported").elements("function")) {
    run.not_exported.push_back({read_text(missing.at("function")),
                                missing.has("law") ? read_text(missing.at("law")) : ""});
  }
  if (const JsonNode told = root.at("passed"); told.boolean() != passed(run)) {
    told.fail(std::string("it is ") + (passed(run) ? "false" : "true") +
              ", but the verdicts of the laws say otherwise");
  }
  return run;
}

[[nodiscard]] LocatedJson parsed(std::string file, std::string_view text) {
  try {
    return parse_located(std::move(file), text);
  } catch (const UserError& error) {
    throw UserError(std::string(error.what()) + "; " + kNeeded);
  }
}

}  // namespace

VerifyRun read_verdict(const std::string& file, std::string_view text) {
  if (text.empty()) throw UserError(file + ": the file is empty; " + kNeeded);
  const LocatedJson located = parsed(file, text);
  return read_run(JsonNode(located));
}

}  // namespace selvage::cli
