// Holding a subject against the laws: seeds in, a verdict out.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "spec/laws.h"

namespace selvage::spec {

struct LawVerdict {
  const Law* law = nullptr;
  uint64_t cases = 0;
  uint64_t judged_px = 0;
  std::optional<Violation> violation;  // of the smallest case found
  std::optional<Case> counterexample;  // the shrunk case that replays it
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
