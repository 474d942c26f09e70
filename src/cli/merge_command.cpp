#include "cli/merge_command.h"

#include <algorithm>
#include <sstream>
#include <tuple>
#include <utility>

#include "cli/corpus.h"
#include "cli/error.h"
#include "cli/file.h"
#include "cli/junit.h"
#include "cli/verdict_json.h"
#include "spec/law_tools.h"

namespace selvage::cli {
namespace {

// "COV MAP", and what else runs have lists of.
template <class Items, class Text>
[[nodiscard]] std::string listed(const Items& items, const Text& text) {
  std::string list;
  for (const auto& item : items) list += (list.empty() ? "" : " ") + std::string(text(item));
  return list;
}

// What all shards of a run have in common.
void demand_one_run(const ShardFile& first, const ShardFile& other) {
  const auto demand = [&](const std::string& what, const auto& told) {
    std::ostringstream one, two;
    one << told(first.run);
    two << told(other.run);
    if (one.str() == two.str()) return;
    throw UserError("these are shards of different runs: " + what + " is '" + one.str() + "' in '" +
                    first.name + "' and '" + two.str() + "' in '" + other.name + "'");
  };
  demand("the subject", [](const VerifyRun& run) { return run.subject; });
  demand("the profile", [](const VerifyRun& run) { return run.profile; });
  demand("the accuracy in 1/65536 texel", [](const VerifyRun& run) { return run.accuracy_fx16; });
  demand("the accuracy of coverage in 1/65536 px",
         [](const VerifyRun& run) { return run.coverage_accuracy_fx16; });
  demand("the seed", [](const VerifyRun& run) { return run.seed; });
  demand("the number of cases", [](const VerifyRun& run) { return run.cases; });
  demand("the number of hunted cases", [](const VerifyRun& run) { return run.hunted; });
  demand("what the subject was told by", [](const VerifyRun& run) { return run.arguments; });
  demand("the number of shards", [](const VerifyRun& run) { return run.shard.count; });
  demand("the list of laws", [](const VerifyRun& run) {
    return listed(run.verdicts, [](const Verdict& law) { return law.found.law->name; });
  });
  demand("the list of functions that are not exported", [](const VerifyRun& run) {
    return listed(run.not_exported, [](const NotExported& missing) { return missing.function; });
  });
  demand("whether ORACLE is missing",
         [](const VerifyRun& run) { return run.oracle_missing ? "yes" : "no"; });
}

// In order of their shards.
void demand_all_shards(const std::vector<ShardFile>& files) {
  const uint64_t count = files.front().run.shard.count;
  const auto shard = [&](uint64_t index) {
    return "shard " + std::to_string(index) + "/" + std::to_string(count);
  };
  uint64_t next = 1;
  for (size_t i = 0; i < files.size(); ++i, ++next) {
    const uint64_t index = files[i].run.shard.index;
    if (index > next) break;
    if (index == next) continue;
    throw UserError(shard(index) + " is there twice: '" + files[i - 1].name + "' and '" +
                    files[i].name + "'");
  }
  if (next <= count) throw UserError(shard(next) + " is missing");
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

// What became of the known violations: of all that were there when the last shard began.
[[nodiscard]] bool is_less(const Known& a, const Known& b) {
  return std::tie(a.tried, a.not_judged) < std::tie(b.tried, b.not_judged);
}

[[nodiscard]] Verdict sum(const std::vector<ShardFile>& files, size_t law) {
  Verdict total;
  total.found.law = files.front().run.verdicts[law].found.law;
  Known known;
  uint64_t time_ns = 0;
  for (const ShardFile& file : files) {
    const Verdict& part = file.run.verdicts[law];
    if (is_less(known, part.known)) known = part.known;
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

VerifyRun merged(std::vector<ShardFile> files) {
  std::ranges::stable_sort(files, {}, [](const ShardFile& file) { return file.run.shard.index; });
  for (const ShardFile& file : files) demand_one_run(files.front(), file);
  demand_all_shards(files);
  VerifyRun whole = files.front().run;
  whole.shard = {};
  const auto known_cases = [](const ShardFile& file) { return file.run.known_cases; };
  const VerifyRun& last = std::ranges::max_element(files, {}, known_cases)->run;
  whole.known_cases = last.known_cases;
  whole.known_of_others = last.known_of_others;
  for (size_t law = 0; law < whole.verdicts.size(); ++law) whole.verdicts[law] = sum(files, law);
  note_not_promised(&whole);
  return whole;
}

int run_merge(const MergeOptions& options, const Console& console) {
  std::vector<ShardFile> files;
  for (const std::string& name : options.files) {
    files.push_back({name, read_verdict(name, read_text_file(name))});
  }
  const VerifyRun whole = merged(std::move(files));
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
