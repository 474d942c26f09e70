#include "spec/verify.h"

#include <algorithm>
#include <utility>

#include "spec/generate.h"
#include "spec/generate_historic.h"
#include "spec/hunt.h"
#include "spec/law_tools.h"

namespace selvage::spec {
namespace {

constexpr int kMaxShrinkingChecks = 4000;
constexpr int kMaxStepsAtAPlace = 16;
constexpr int kMaxShrinkingHangs = 4;  // each takes all the time that a call has
constexpr uint64_t kProgressSteps = 100;

constexpr uint64_t kReplays = 3;

}  // namespace

// A case with the violation that was seen on it.
struct Verification::Failure {
  Case on;
  Violation violation;
  bool hung = false;
  std::shared_ptr<const Drawings> drawings{};
  bool is_smallest = true;
};

namespace {

using Failure = Verification::Failure;

// Such a call says nothing of a pixel: what should have held, and what happened.
[[nodiscard]] Violation violation_by(const SubjectFailure& failure, const Law& law, const Case& c) {
  return {.law = std::string(law.name),
          .what = "a call ends, and touches nothing but what it was given" +
                  (failure.call.empty() ? "" : ": " + failure.call),
          .allowed = "a picture or a named error",
          .drawn = "it " + failure.happened,
          .shown = failure.shown.value_or(c),
          .is_of_call = true};
}

struct Outcome {
  Judgement judgement;
  bool hung = false;
  std::shared_ptr<Drawings> drawings = std::make_shared<Drawings>();
};

[[nodiscard]] Outcome try_out(const Law& law, const Subject& subject, const Case& c) {
  if (subject.begin_case) subject.begin_case();
  Outcome outcome;
  Subject noted = subject;
  noted.noted_in = outcome.drawings.get();
  try {
    outcome.judgement = law.check(noted, c);
  } catch (const SubjectFailure& failure) {
    outcome.judgement.violation = violation_by(failure, law, c);
    outcome.hung = failure.hung;
  } catch (const NotClaimed& not_claimed) {
    outcome.judgement.not_claimed = not_claimed.what;
  }
  return outcome;
}

[[nodiscard]] Failure failure_of(Case c, Outcome outcome) {
  return {std::move(c), std::move(*outcome.judgement.violation), outcome.hung,
          std::move(outcome.drawings)};
}

// Steps to a simpler case that fails as well, until there is none or the checks are used up. After
// a step it goes on where that step was found: what was tried before it is likely to pass again.
// But not for ever: a texture loses a texel thousands of times where by now it may lose all.
// `anew`: each is tried in a subject that has drawn nothing before.
[[nodiscard]] Failure descend(const Law& law, const Subject& subject, Failure failure,
                              const Effort& effort, bool anew = false) {
  const bool shrinks =
      effort.shrinks && (!failure.hung || !effort.shrinks_hangs || effort.shrinks_hangs());
  int checks_left = shrinks ? kMaxShrinkingChecks : 0, hangs_left = kMaxShrinkingHangs;
  size_t place = 0;
  int steps_there = 0;
  failure.is_smallest = false;
  for (bool found = true; found;) {
    found = false;
    std::vector<Case> candidates = simpler(failure.on);
    if (steps_there == kMaxStepsAtAPlace) ++place;
    steps_there %= kMaxStepsAtAPlace;
    for (size_t tried = 0; tried < candidates.size(); ++tried, ++place, steps_there = 0) {
      if (checks_left-- == 0 || hangs_left == 0) return failure;
      if (effort.is_over && effort.is_over()) return failure;
      if (effort.tries) effort.tries();
      if (anew) subject.start_anew();
      Case& candidate = candidates[place % candidates.size()];
      Outcome outcome = try_out(law, subject, candidate);
      if (outcome.hung) --hangs_left;
      if (!outcome.judgement.violation) continue;
      failure = failure_of(std::move(candidate), std::move(outcome));
      failure.is_smallest = false;
      ++steps_there;
      found = true;
      break;
    }
  }
  failure.is_smallest = true;
  return failure;
}

// What hangs takes all the time that a call has: once is enough.
[[nodiscard]] Replays replay(const Law& law, const Subject& subject, const Failure& failure,
                             const Effort& effort) {
  Replays replays;
  while (replays.tried < (failure.hung ? 1 : kReplays)) {
    if (effort.is_over && effort.is_over()) return replays;
    if (subject.start_anew) subject.start_anew();
    ++replays.tried;
    if (try_out(law, subject, failure.on).judgement.violation) ++replays.failed;
  }
  return replays;
}

}  // namespace

Judgement judge(const Law& law, const Subject& subject, const Case& c) {
  return try_out(law, subject, c).judgement;
}

void Verification::check(uint64_t first_seed, uint64_t number) {
  if (verdict_.violation) return;
  check(within(subject_.claims, generate(first_seed + number, subject_.profile)), number);
}

void Verification::check(const Case& c, uint64_t number) {
  if (!verdict_.violation) (void)add_up(c, number);
}

Score Verification::check_hunted(const Case& c, uint64_t number) {
  if (verdict_.violation) return {};
  const Score score = score_of(*verdict_.law, c, add_up(c, number));
  ++verdict_.hunted.cases;
  verdict_.hunted.found = verdict_.violation.has_value();
  std::optional<Score>& best = verdict_.hunted.best;
  if (!best || score > *best) best = score;
  if (verdict_.violation) best.reset();
  return score;
}

// The margin of this case alone.
std::optional<Margin> Verification::add_up(const Case& c, uint64_t number) {
  Outcome outcome = try_out(*verdict_.law, subject_, c);
  const Judgement judgement = outcome.judgement;
  ++verdict_.cases;
  verdict_.judged_px += judgement.judged_px;
  add(&verdict_.margin, judgement.margin);
  if (judgement.not_claimed) ++verdict_.not_claimed[*judgement.not_claimed];
  if (!judgement.violation) return judgement.margin;
  verdict_.failed_case = number;
  verdict_.judged_px = judgement.judged_px;
  verdict_.margin.reset();
  verdict_.not_claimed.clear();
  shrink_and_replay(failure_of(c, std::move(outcome)));
  return judgement.margin;
}

// What the smallest case does by itself is not what it did after others: then a subject that is
// started anew for each is shrunk on, if the case fails there at all.
void Verification::shrink_and_replay(Failure first) {
  const Law& law = *verdict_.law;
  verdict_.found_case = first.on;
  Failure least = descend(law, subject_, first, effort_);
  Replays replays = replay(law, subject_, least, effort_);
  if (replays.failed < replays.tried && subject_.start_anew && effort_.shrinks) {
    const Replays of_first = replay(law, subject_, first, effort_);
    if (of_first.tried > 0 && of_first.failed == of_first.tried) {
      least = descend(law, subject_, std::move(first), effort_, /*anew=*/true);
      replays = replay(law, subject_, least, effort_);
    }
  }
  verdict_.violation = std::move(least.violation);
  verdict_.counterexample = std::move(least.on);
  verdict_.is_smallest = least.is_smallest;
  verdict_.hung = least.hung;
  verdict_.drawings = std::move(least.drawings);
  verdict_.replays = replays;
}

LawVerdict verify(const Law& law, const Subject& subject, uint64_t first_seed, uint64_t case_count,
                  const std::function<void(uint64_t)>& progress) {
  const uint64_t progress_every = std::max<uint64_t>(1, case_count / kProgressSteps);
  Verification verification(law, subject);
  for (uint64_t number = 0; number < case_count; ++number) {
    verification.check(first_seed, number);
    if (verification.verdict().violation) break;
    if (progress && (number + 1) % progress_every == 0) progress(number + 1);
  }
  return verification.verdict();
}

Case shrink(const Law& law, const Subject& subject, Case c) {
  return descend(law, subject, {std::move(c), {}}, {}).on;
}

}  // namespace selvage::spec
