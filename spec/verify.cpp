#include "spec/verify.h"

#include <algorithm>
#include <utility>

#include "spec/generate.h"
#include "spec/generate_historic.h"

namespace selvage::spec {
namespace {

constexpr int kMaxShrinkingChecks = 4000;
constexpr uint64_t kProgressSteps = 100;

// A case with the violation that was seen on it.
struct Failure {
  Case on;
  Violation violation;
};

// Steps to a simpler case that fails as well, until there is none or the checks are used up. After
// a step it goes on where that step was found: what was tried before it is likely to pass again.
[[nodiscard]] Failure descend(const Law& law, const Subject& subject, Failure failure) {
  int checks_left = kMaxShrinkingChecks;
  size_t place = 0;
  for (bool found = true; found;) {
    found = false;
    std::vector<Case> candidates = simpler(failure.on);
    for (size_t tried = 0; tried < candidates.size(); ++tried, ++place) {
      if (checks_left-- == 0) return failure;
      Case& candidate = candidates[place % candidates.size()];
      Judgement judgement = law.check(subject, candidate);
      if (!judgement.violation) continue;
      failure = {std::move(candidate), std::move(*judgement.violation)};
      found = true;
      break;
    }
  }
  return failure;
}

}  // namespace

LawVerdict verify(const Law& law, const Subject& subject, uint64_t first_seed, uint64_t case_count,
                  const std::function<void(uint64_t)>& progress) {
  LawVerdict verdict;
  verdict.law = &law;
  const uint64_t progress_every = std::max<uint64_t>(1, case_count / kProgressSteps);
  while (verdict.cases < case_count) {
    Case c = generate(first_seed + verdict.cases, subject.profile);
    if (subject.nearest_only) c.filter = SELVAGE_FILTER_NEAREST;
    Judgement judgement = law.check(subject, c);
    ++verdict.cases;
    verdict.judged_px += judgement.judged_px;
    if (judgement.violation) {
      Failure least = descend(law, subject, {std::move(c), std::move(*judgement.violation)});
      verdict.violation = std::move(least.violation);
      verdict.counterexample = std::move(least.on);
      return verdict;
    }
    if (progress && verdict.cases % progress_every == 0) progress(verdict.cases);
  }
  return verdict;
}

Case shrink(const Law& law, const Subject& subject, Case c) {
  return descend(law, subject, {std::move(c), {}}).on;
}

}  // namespace selvage::spec
