// One law's part of a run of `selvage verify`: known violations, random cases, the hunt.
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <vector>

#include "cli/corpus.h"
#include "cli/verdict.h"
#include "spec/verify.h"

namespace selvage::cli {

class LawRun {
 public:
  // Where the effort's time is over, what is left to do is cut short.
  LawRun(const spec::Law& law, const spec::Subject& subject, const spec::Effort& effort = {})
      : subject_(subject), effort_(effort), verification_(law, subject, effort) {}

  // Adds the time that the work takes to the law's.
  template <typename Work>
  void timed(Work work) {
    const auto start = Clock::now();
    work();
    time_ += Clock::now() - start;
  }

  [[nodiscard]] bool is_violated() const { return verification_.verdict().violation.has_value(); }

  [[nodiscard]] bool hangs() const { return verification_.verdict().hung; }

  // Known violations of this law, each as the subject's profile and claims take it. They count
  // among the cases only where they still are some.
  void try_known(const std::vector<KnownCase>& known);
  void check(uint64_t seed, uint64_t number) { verification_.check(seed, number); }
  // A climb of the hunt: the cases of number climb * spec::kClimbCases and on, below `most`.
  void hunt(uint64_t seed, uint64_t climb, uint64_t most);
  // This one case instead; nothing is shrunk.
  void replay(const spec::Case& c);

  // Of a run over all cases of the shards, `random_cases` of them random: as the run in one piece
  // would tell it, which has checked all cases before the one that failed.
  [[nodiscard]] Verdict verdict(uint64_t random_cases) const;
  // As far as it came.
  [[nodiscard]] Verdict verdict() const;

 private:
  using Clock = std::chrono::steady_clock;

  const spec::Subject& subject_;
  spec::Effort effort_;
  spec::Verification verification_;
  std::optional<spec::LawVerdict> replayed_;
  Known known_;
  Clock::duration time_{};
  bool from_corpus_ = false;
};

}  // namespace selvage::cli
