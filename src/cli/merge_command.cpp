#include "cli/merge_command.h"

#include <algorithm>
#include <map>
#include <span>
#include <utility>

#include "cli/corpus.h"
#include "cli/error.h"
#include "cli/file.h"
#include "cli/junit.h"
#include "cli/verdict_json.h"
#include "spec/law_tools.h"

namespace selvage::cli {
namespace {

// What all shards of a run have in common.
void demand_one_run(const VerifyRun& first, const std::string& first_name, const VerifyRun& other,
                    const std::string& name) {
  const auto demand = [&](bool same, const std::string& what, const std::string& one,
                          const std::string& two) {
    if (same) return;
    throw UserError("these are shards of different runs: " + what + " is '" + one + "' in '" +
                    first_name + "' and '" + two + "' in '" + name + "'");
  };
  const auto text = [](uint64_t number) { return std::to_string(number); };
  demand(first.subject == other.subject, "the subject", first.subject, other.subject);
  demand(first.profile == other.profile, "the profile", first.profile, other.profile);
  demand(first.accuracy_fx16 == other.accuracy_fx16, "the accuracy in 1/65536 texel",
         std::to_string(first.accuracy_fx16), std::to_string(other.accuracy_fx16));
  demand(first.seed == other.seed, "the seed", text(first.seed), text(other.seed));
  demand(first.cases == other.cases, "the number of cases", text(first.cases), text(other.cases));
  demand(first.hunted == other.hunted, "the number of hunted cases", text(first.hunted),
         text(other.hunted));
  demand(first.arguments == other.arguments, "what the subject was told by", first.arguments,
         other.arguments);
  demand(first.shard.count == other.shard.count, "the number of shards", text(first.shard.count),
         text(other.shard.count));
  const auto laws = [](const VerifyRun& run) {
    std::string names;
    for (const Verdict& verdict : run.verdicts) names += std::string(verdict.found.law->name) + " ";
    return names;
  };
  demand(laws(first) == laws(other), "the list of laws", laws(first), laws(other));
}

void demand_all_shards(const std::vector<VerifyRun>& runs, const std::vector<std::string>& names) {
  const uint64_t count = runs.front().shard.count;
  std::map<uint64_t, std::string> seen;
  for (size_t i = 0; i < runs.size(); ++i) {
    std::string& before = seen[runs[i].shard.index];
    const std::string shard = std::to_string(runs[i].shard.index) + "/" + std::to_string(count);
    if (!before.empty()) {
      throw UserError("shard " + shard + " is there twice: '" + before + "' and '" + names[i] +
                      "'");
    }
    before = names[i];
  }
  uint64_t next = 1;  // at most one more than there are files, however many shards are said to be
  while (seen.contains(next)) ++next;
  if (next <= count) {
    throw UserError("shard " + std::to_string(next) + "/" + std::to_string(count) + " is missing");
  }
}

// Which of two violations a run in one piece would have met first.
[[nodiscard]] bool is_before(const Verdict& a, const Verdict& b) {
  if (!b.found.violation) return a.found.violation.has_value();
  if (!a.found.violation) return false;
  if (a.from_corpus != b.from_corpus) return a.from_corpus;
  if (a.found.hunted.found != b.found.hunted.found) return b.found.hunted.found;
  return a.found.failed_case < b.found.failed_case;
}

void add(spec::Hunted* total, const spec::Hunted& part) {
  total->cases += part.cases;
  if (part.best && (!total->best || *part.best > *total->best)) total->best = part.best;
}

[[nodiscard]] Verdict sum(const std::vector<VerifyRun>& runs, size_t law) {
  Verdict total;
  total.found.law = runs.front().verdicts[law].found.law;
  Known known;  // every shard tries all of them that were there when it began
  uint64_t time_ns = 0;
  for (const VerifyRun& run : runs) {
    const Verdict& part = run.verdicts[law];
    if (part.known.tried > known.tried) known = part.known;
    time_ns += static_cast<uint64_t>(part.time_ns);
    if (is_before(part, total)) total = part;
    total.lacked_time |= part.lacked_time;
    if (total.not_promised.empty()) total.not_promised = part.not_promised;
    if (total.in_part.empty()) total.in_part = part.in_part;
    if (total.found.violation) continue;
    total.found.cases += part.found.cases;
    total.found.judged_px += part.found.judged_px;
    spec::add(&total.found.margin, part.found.margin);
    add(&total.found.hunted, part.found.hunted);
    for (const auto& [what, cases] : part.found.not_claimed) total.found.not_claimed[what] += cases;
  }
  total.known = std::move(known);
  total.time_ns = static_cast<int64_t>(time_ns);
  return total;
}

}  // namespace

VerifyRun merged(const std::vector<VerifyRun>& runs, const std::vector<std::string>& names) {
  for (size_t i = 1; i < runs.size(); ++i) {
    demand_one_run(runs.front(), names.front(), runs[i], names[i]);
  }
  demand_all_shards(runs, names);
  VerifyRun whole = runs.front();
  whole.shard = {};
  const VerifyRun& last = *std::ranges::max_element(runs, {}, &VerifyRun::known_cases);
  whole.known_cases = last.known_cases;
  whole.known_of_others = last.known_of_others;
  for (size_t law = 0; law < whole.verdicts.size(); ++law) whole.verdicts[law] = sum(runs, law);
  note_not_promised(&whole);
  return whole;
}

int run_merge(const MergeOptions& options, const Console& console) {
  std::vector<VerifyRun> runs;
  for (const std::string& file : options.files) {
    runs.push_back(read_verdict(file, read_text_file(file)));
  }
  const VerifyRun whole = merged(runs, options.files);
  if (!options.junit.empty()) check_output(options.junit);
  if (!options.corpus.empty()) make_corpus(options.corpus, console);
  add_to_corpus(options.corpus, whole);
  if (!options.junit.empty()) write_text_file(options.junit, junit_xml(whole));
  if (options.json) {
    console.out << verdict_json(whole);
    return exit_code(whole);
  }
  console.out << subject_line(whole) << "\nseed " << whole.seed << '\n' << table_header();
  for (const Verdict& verdict : whole.verdicts) console.out << table_row(verdict);
  console.out << table_summary(whole) << explanations(whole);
  return exit_code(whole);
}

}  // namespace selvage::cli
