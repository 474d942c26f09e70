// The hunt for counterexamples: climbs from case to case, each no farther from a violation than the
// one before. It knows the law's margin and the exact model, and nothing of the mapper but what it
// draws.
//
// A law with a bound is climbed on measured / bound. An exact one has no such slope: a texel is
// right or wrong. It is climbed on the case's closeness to ties, which the model tells.
#pragma once

#include <compare>
#include <cstdint>
#include <optional>
#include <string_view>

#include "spec/mutate_case.h"
#include "spec/verify.h"

namespace selvage::spec {

// What decides whether the law holds: where edges lie, what u and v are, both, or neither.
[[nodiscard]] Aim aim_at(std::string_view law);

// The score of a case that a law was judged on.
[[nodiscard]] Score score_of(const Law& law, const Case& c, const std::optional<Margin>& margin);

inline constexpr uint64_t kClimbCases = 12;  // then another climb begins elsewhere

// One climb. The same law, claims, profile, seed and number always make the same one, as long as
// the subject draws the same.
class Climb {
 public:
  Climb(const Law& law, const Subject& subject, uint64_t seed, uint64_t number);

  // The next case to be judged, as profile and claims of the subject take it: first where the climb
  // begins, the closest of a few generated cases; then, of a few mutations of the case that it has
  // got to, the closest. Where there is nothing to climb on, each is generated.
  [[nodiscard]] Case propose();
  // Goes on from a case that was judged if its score is no less than what the climb has got to.
  void weigh(Case c, const Score& score);

  [[nodiscard]] const std::optional<Score>& score() const { return score_; }

 private:
  [[nodiscard]] Case generated();
  template <typename Make>
  [[nodiscard]] Case closest_of(int count, Make make);

  const Law& law_;
  const Subject& subject_;
  Random random_;
  Case at_;
  std::optional<Score> score_;
};

// Climb `number` of a hunt, over `most` cases at most: they count as the hunted cases number *
// kClimbCases and on. Ends with the first violation.
void hunt(Verification* verification, uint64_t seed, uint64_t number, uint64_t most = kClimbCases);

}  // namespace selvage::spec
