#include "cli/law_run.h"

#include <utility>

#include "spec/hunt.h"
#include "spec/profiles.h"

namespace selvage::cli {

void LawRun::try_known(const std::vector<KnownCase>& known) {
  const spec::Law& law = *verification_.verdict().law;
  for (const KnownCase& one : known) {
    if (is_violated() || one.law != law.name) continue;
    if (effort_.is_over && effort_.is_over()) return;
    const spec::Case c = within(subject_.claims, spec::to_profile(one.found, subject_.profile));
    const spec::Judgement judgement = spec::judge(law, subject_, c);
    ++known_.tried;
    if (judgement.violation) {
      verification_.check(c, 0);
      from_corpus_ = is_violated();
    } else if (judgement.not_claimed) {
      ++known_.not_judged[*judgement.not_claimed];
    } else if (judgement.judged_px == 0) {
      ++known_.not_judged["nothing of it is left to judge"];
    }
  }
}

void LawRun::hunt(uint64_t seed, uint64_t climb, uint64_t most) {
  const uint64_t first = climb * spec::kClimbCases;
  if (first < most) spec::hunt(&verification_, seed, climb, most - first);
}

void LawRun::replay(const spec::Case& c) {
  auto drawings = std::make_shared<spec::Drawings>();
  spec::Subject noted = subject_;
  noted.noted_in = drawings.get();
  spec::Judgement judgement = spec::judge(*verification_.verdict().law, noted, c);
  replayed_ = verification_.verdict();
  replayed_->drawings = std::move(drawings);
  replayed_->cases = 1;
  replayed_->judged_px = judgement.judged_px;
  replayed_->margin = judgement.margin;
  if (judgement.not_claimed) replayed_->not_claimed[*judgement.not_claimed] = 1;
  replayed_->violation = std::move(judgement.violation);
  if (replayed_->violation) replayed_->counterexample = c;
}

Verdict LawRun::verdict() const {
  return {.found = replayed_ ? *replayed_ : verification_.verdict(),
          .time_ns = std::chrono::nanoseconds(time_).count(),
          .picture = {},
          .from_corpus = from_corpus_,
          .known = known_};
}

Verdict LawRun::verdict(uint64_t random_cases) const {
  Verdict verdict = this->verdict();
  if (!is_violated() || from_corpus_) return verdict;
  spec::LawVerdict& found = verdict.found;
  found.hunted.cases = found.hunted.found ? found.failed_case + 1 : 0;
  found.cases = found.hunted.found ? random_cases + found.hunted.cases : found.failed_case + 1;
  return verdict;
}

}  // namespace selvage::cli
