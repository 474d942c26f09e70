// Holding a subject against the laws: seeds in, a verdict out.
#pragma once

#include <compare>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "spec/drawings.h"
#include "spec/laws.h"

namespace selvage::spec {

// How near a case came to breaking a law: by what the law measured, then by how close to ties the
// case lies (spec/hunt.h). Each from 0 to 1.
struct Score {
  double share = 0;      // measured / bound; 0 of an exact law
  double closeness = 0;  // of the most that there can be

  friend auto operator<=>(const Score&, const Score&) = default;
};

// What of a verdict came out of the hunt.
struct Hunted {
  uint64_t cases = 0;
  std::optional<Score> best{};  // of all hunted cases; empty where the law is violated
  bool found = false;           // the violation, if there is one
};

// The counterexample, judged anew in a subject that has drawn nothing before.
struct Replays {
  uint64_t tried = 0, failed = 0;

  friend bool operator==(const Replays&, const Replays&) = default;
};

struct LawVerdict {
  const Law* law = nullptr;
  uint64_t cases = 0;
  // In all cases; where one violates the law, in that one alone. So it does not depend on how the
  // cases are shared out, nor do the two fields below, which are then empty.
  uint64_t judged_px = 0;
  std::optional<Violation> violation{};  // of the smallest case found
  std::optional<Case> counterexample{};  // the shrunk case that replays it
  std::optional<Case> found_case{};      // that case as it was found; if violated
  uint64_t failed_case = 0;              // the number of the case that was shrunk; if violated
  bool is_smallest = true;               // there is no smaller one; if violated
  bool hung = false;                     // what violates it is a call that took all its time
  Replays replays{};                     // if violated; fewer failed: it depends on more
  std::shared_ptr<const Drawings> drawings{};     // of the counterexample when it failed
  std::optional<Margin> margin{};                 // of all cases, the nearest to the law's bound
  std::map<std::string, uint64_t> not_claimed{};  // cases that were not judged, by what they want
  Hunted hunted{};                                // these cases count above, too
};

// Checks a law on a case. What the subject fails by is a violation, what it does not claim is told.
[[nodiscard]] Judgement judge(const Law& law, const Subject& subject, const Case& c);

// What is done about a violation once it is found.
struct Effort {
  bool shrinks = true;
  // Asked where a call hung: each that is tried takes all the time that a call has. Empty: it does.
  std::function<bool()> shrinks_hangs{};
  // Asked before each case that is tried: where the time is over, no more are. Empty: it never is.
  std::function<bool()> is_over{};
  std::function<void()> tries{};  // called before a smaller case is tried; may be empty
};

// One law being held against a subject, case by case. Nothing happens once it is violated.
class Verification {
 public:
  Verification(const Law& law, const Subject& subject, Effort effort = {})
      : subject_(subject), effort_(std::move(effort)) {
    verdict_.law = &law;
  }

  // Checks case `number` of a run: that of seed first_seed + number, as profile and claims of the
  // subject take it.
  void check(uint64_t first_seed, uint64_t number);
  // Checks a given case, which counts as number `number`.
  void check(const Case& c, uint64_t number);
  // Checks a case of a hunt, which is number `number` of those, and tells how near it came.
  Score check_hunted(const Case& c, uint64_t number);
  [[nodiscard]] const LawVerdict& verdict() const { return verdict_; }
  [[nodiscard]] const Subject& subject() const { return subject_; }

  struct Failure;

 private:
  std::optional<Margin> add_up(const Case& c, uint64_t number);
  void shrink_and_replay(Failure first);

  const Subject& subject_;
  Effort effort_;
  LawVerdict verdict_;
};

// Checks one law on the cases of seeds first_seed, first_seed + 1, ..., as the subject's profile
// takes them, and stops at the first violation, which is then shrunk. `progress` is called now and
// then with the cases done; may be empty.
[[nodiscard]] LawVerdict verify(const Law& law, const Subject& subject, uint64_t first_seed,
                                uint64_t case_count,
                                const std::function<void(uint64_t)>& progress = {});

// The simplest case that descent finds on which the law still fails; c itself must fail.
[[nodiscard]] Case shrink(const Law& law, const Subject& subject, Case c);

}  // namespace selvage::spec
