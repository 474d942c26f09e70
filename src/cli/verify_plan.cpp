#include "cli/verify_plan.h"

#include <algorithm>
#include <deque>

#include "cli/error.h"
#include "cli/law_run.h"
#include "cli/number.h"
#include "cli/status_line.h"
#include "spec/hunt.h"
#include "spec/promise.h"

namespace selvage::cli {
namespace {

using Clock = std::chrono::steady_clock;

constexpr uint64_t kCasesPerRound = 20;
constexpr auto kFirstRoundGrace = std::chrono::seconds(5);
constexpr double kMostRunTime_s = 1e6;

void check_shard(const VerifyPlan& plan, StatusLine& status, LawRun* run, std::string_view law) {
  for (uint64_t number = plan.shard.index - 1; number < plan.cases; number += plan.shard.count) {
    if (run->is_violated()) return;
    run->check(plan.seed, number);
    status.count(law, number + 1, plan.cases);
  }
}

// Climbs are shared out as cases are.
void hunt_shard(const VerifyPlan& plan, StatusLine& status, LawRun* run, std::string_view law) {
  const std::string what = std::string(law) + ", hunted";
  for (uint64_t climb = plan.shard.index - 1; climb * spec::kClimbCases < plan.hunted;
       climb += plan.shard.count) {
    if (run->is_violated()) return;
    run->hunt(plan.seed, climb, plan.hunted);
    status.count(what, std::min((climb + 1) * spec::kClimbCases, plan.hunted), plan.hunted);
  }
}

// A round that has to be cut short has no more cases for its law.
void check_round(const VerifyPlan& plan, uint64_t first, Clock::time_point end, bool is_first,
                 LawRun* run) {
  for (uint64_t i = 0; i < kCasesPerRound; ++i) {
    if (!is_first && Clock::now() >= end) return;
    if (Clock::now() >= end + kFirstRoundGrace) return;
    run->check(plan.seed, first + i);
  }
  if (Clock::now() < end) run->hunt(plan.seed, first / kCasesPerRound, plan.hunted);
}

// Every law gets a round of cases and a climb in turn, and each at least one round: of a subject
// that hangs, and where the time has long been over, the laws before have had all there was.
void check_rounds(const VerifyPlan& plan, StatusLine& status, Clock::time_point end,
                  std::deque<LawRun>* runs) {
  const auto most = static_cast<uint64_t>(plan.time->count() / 1'000'000'000);
  for (uint64_t first = 0; first == 0 || Clock::now() < end; first += kCasesPerRound) {
    for (LawRun& run : *runs) {
      const bool waits = first == 0 && std::ranges::none_of(*runs, &LawRun::hangs);
      if (!waits && Clock::now() >= end) return;
      run.timed([&] { check_round(plan, first, end, waits, &run); });
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

uint64_t parse_hunt(const std::string& text, bool by_time) {
  constexpr uint64_t kMost = 1'000'000'000;
  if (text.empty()) return by_time ? kMost : 0;
  const std::optional<uint64_t> count = parse_integer<uint64_t>(text);
  if (!count || *count > kMost) {
    throw UserError("--hunt: '" + text + "' is no number from 0 to " + std::to_string(kMost));
  }
  return *count;
}

std::chrono::nanoseconds parse_time(const std::string& text) {
  const std::optional<double> seconds = parse_double(text);
  if (!seconds || *seconds <= 0 || *seconds > kMostRunTime_s) {
    throw UserError("--time: '" + text + "' is no time; more than 0 and up to 1000000 seconds are");
  }
  return std::chrono::nanoseconds(static_cast<int64_t>(*seconds * 1e9));
}

std::vector<Verdict> carry_out(const VerifyPlan& plan, const spec::Subject& subject,
                               const Console& console,
                               const std::function<void(const Verdict&)>& done) {
  const auto end = Clock::now() + plan.time.value_or(std::chrono::nanoseconds(0));
  StatusLine status(console);
  std::deque<LawRun> runs;  // which stay where they are
  // Of a subject that hangs one law's counterexample is shrunk.
  const auto effort = [&](const spec::Law* law) {
    return spec::Effort{
        .shrinks = plan.shrinks,
        .shrinks_hangs = [&runs] { return std::ranges::none_of(runs, &LawRun::hangs); },
        .is_over = [&plan, end] { return plan.time && Clock::now() >= end; },
        .tries = [&status,
                  law] { status.show_now_and_then(std::string(law->name) + ", shrinking"); }};
  };
  const auto told = [&](Verdict verdict) {
    const auto why = plan.not_promised.find(verdict.found.law);
    if (why != plan.not_promised.end()) {
      verdict.not_promised = why->second;
    } else {
      const auto& law = verdict.found.law->name;
      verdict.in_part = spec::promise(subject.profile, subject.claims, law).note;
    }
    return verdict;
  };
  for (const spec::Law* law : plan.laws) {
    LawRun& run = runs.emplace_back(*law, subject, effort(law));
    run.timed([&] {
      run.try_known(plan.known);
      if (plan.replayed) run.replay(*plan.replayed);
      if (plan.replayed || plan.time) return;
      check_shard(plan, status, &run, law->name);
      hunt_shard(plan, status, &run, law->name);
    });
    status.wipe();
    if (!plan.time) done(told(run.verdict(plan.cases)));
  }
  if (plan.time) check_rounds(plan, status, end, &runs);
  status.wipe();
  std::vector<Verdict> verdicts;
  for (const LawRun& run : runs) {
    verdicts.push_back(told(plan.time ? run.verdict() : run.verdict(plan.cases)));
    if (!plan.time) continue;
    const spec::LawVerdict& found = verdicts.back().found;
    verdicts.back().lacked_time =
        Clock::now() >= end && found.cases < kCasesPerRound && found.judged_px == 0;
    done(verdicts.back());
  }
  return verdicts;
}

}  // namespace selvage::cli
