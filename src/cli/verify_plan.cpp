#include "cli/verify_plan.h"

#include <algorithm>
#include <deque>

#include "cli/error.h"
#include "cli/number.h"
#include "cli/status_line.h"

namespace selvage::cli {
namespace {

using Clock = std::chrono::steady_clock;

constexpr uint64_t kCasesPerRound = 20;
constexpr double kMostTime_s = 1e6;

// One law's part of a run.
class LawRun {
 public:
  LawRun(const spec::Law& law, const spec::Subject& subject)
      : subject_(subject), verification_(law, subject) {}

  template <typename Work>
  void timed(Work work) {
    const auto start = Clock::now();
    work();
    time_ += Clock::now() - start;
  }

  [[nodiscard]] bool is_violated() const { return verification_.verdict().violation.has_value(); }

  // Known violations count only where they still are some.
  void try_known(const std::vector<KnownCase>& known) {
    const spec::Law& law = *verification_.verdict().law;
    for (const KnownCase& one : known) {
      if (is_violated() || one.law != law.name) continue;
      if (one.found.profile != subject_.profile) continue;
      if (!spec::judge(law, subject_, one.found).violation) continue;
      verification_.check(one.found, 0);
      from_corpus_ = is_violated();
    }
  }

  void check(uint64_t seed, uint64_t number) { verification_.check(seed, number); }
  void check(const spec::Case& c) {
    spec::Judgement judgement = spec::judge(*verification_.verdict().law, subject_, c);
    replayed_ = verification_.verdict();
    replayed_->cases = 1;
    replayed_->judged_px = judgement.judged_px;
    replayed_->margin = judgement.margin;
    if (judgement.not_claimed) replayed_->not_claimed[*judgement.not_claimed] = 1;
    replayed_->violation = std::move(judgement.violation);
    if (replayed_->violation) replayed_->counterexample = c;
  }

  [[nodiscard]] Verdict verdict() const {
    Verdict verdict{.found = replayed_ ? *replayed_ : verification_.verdict(),
                    .time_ns = std::chrono::nanoseconds(time_).count(),
                    .picture = {},
                    .from_corpus = from_corpus_};
    // Whoever has the other cases: those before the one that failed have been checked.
    if (is_violated() && !from_corpus_) verdict.found.cases = verdict.found.failed_case + 1;
    return verdict;
  }

 private:
  const spec::Subject& subject_;
  spec::Verification verification_;
  std::optional<spec::LawVerdict> replayed_;  // a replay shrinks nothing
  Clock::duration time_{};
  bool from_corpus_ = false;
};

void check_shard(const VerifyPlan& plan, const Console& console, LawRun* run,
                 std::string_view law) {
  StatusLine status(console);
  for (uint64_t number = plan.shard.index - 1; number < plan.cases; number += plan.shard.count) {
    if (run->is_violated()) return;
    run->check(plan.seed, number);
    status.count(law, number + 1, plan.cases);
  }
}

// Every law gets a round of cases in turn, and each at least one.
void check_rounds(const VerifyPlan& plan, const Console& console, std::deque<LawRun>* runs) {
  StatusLine status(console);
  const auto end = Clock::now() + *plan.time;
  const auto most = static_cast<uint64_t>(plan.time->count() / 1'000'000'000);
  for (uint64_t first = 0; first == 0 || Clock::now() < end; first += kCasesPerRound) {
    for (LawRun& run : *runs) {
      if (first > 0 && Clock::now() >= end) return;
      run.timed([&] {
        for (uint64_t i = 0; i < kCasesPerRound; ++i) run.check(plan.seed, first + i);
      });
      const auto left_s =
          static_cast<uint64_t>(std::max<int64_t>(0, (end - Clock::now()).count()) / 1'000'000'000);
      status.count("second", most - std::min(most, left_s), most);
    }
    if (std::ranges::all_of(*runs, &LawRun::is_violated)) return;
  }
}

}  // namespace

Shard parse_shard(const std::string& text, uint64_t cases) {
  if (text.empty()) return {};
  const std::vector<std::string_view> parts = split(text, '/');
  const auto number = [&](size_t i) {
    return parts.size() == 2 ? parse_integer<uint64_t>(parts[i]).value_or(0) : 0;
  };
  const Shard shard{number(0), number(1)};
  if (shard.index < 1 || shard.index > shard.count) {
    throw UserError("--shard: '" + text + "' is no shard; 1/N to N/N are, as 2/8");
  }
  if (shard.count > cases) {
    throw UserError("--shard: " + std::to_string(cases) + " cases are too few for " +
                    std::to_string(shard.count) + " shards");
  }
  return shard;
}

std::chrono::nanoseconds parse_time(const std::string& text) {
  const std::optional<double> seconds = parse_double(text);
  if (!seconds || *seconds <= 0 || *seconds > kMostTime_s) {
    throw UserError("--time: '" + text + "' is no time; more than 0 and up to 1000000 seconds are");
  }
  return std::chrono::nanoseconds(static_cast<int64_t>(*seconds * 1e9));
}

std::vector<Verdict> carry_out(const VerifyPlan& plan, const spec::Subject& subject,
                               const Console& console,
                               const std::function<void(const Verdict&)>& done) {
  std::deque<LawRun> runs;  // which stay where they are
  for (const spec::Law* law : plan.laws) {
    LawRun& run = runs.emplace_back(*law, subject);
    run.timed([&] {
      run.try_known(plan.known);
      if (plan.replayed) run.check(*plan.replayed);
      if (!plan.replayed && !plan.time) check_shard(plan, console, &run, law->name);
    });
    if (!plan.time) done(run.verdict());
  }
  if (plan.time) check_rounds(plan, console, &runs);
  std::vector<Verdict> verdicts;
  for (const LawRun& run : runs) {
    verdicts.push_back(run.verdict());
    if (plan.time) done(verdicts.back());
  }
  return verdicts;
}

}  // namespace selvage::cli
