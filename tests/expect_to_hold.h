// Holding a subject to all that it promises.
#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <functional>

#include "spec/promise.h"
#include "spec/verify.h"

namespace selvage::spec {

// Each promised law holds and has its say; of its cases at most so many are not claimed, for any
// one reason.
inline void expect_to_hold(
    const Subject& subject, uint64_t cases,
    const std::function<uint64_t(const Law&)>& most_not_claimed = [](auto&) {
      return UINT64_MAX;
    }) {
  for (const Law& law : laws()) {
    if (promise(subject.profile, subject.claims, law.name).standing != Standing::kPromised) {
      continue;
    }
    const LawVerdict verdict = verify(law, subject, 1, cases);
    EXPECT_FALSE(verdict.violation) << explain(*verdict.violation);
    EXPECT_GT(verdict.judged_px, 0u) << law.name;
    for (const auto& [what, count] : verdict.not_claimed) {
      EXPECT_LE(count, most_not_claimed(law)) << law.name << " is left out for " << what;
    }
  }
}

}  // namespace selvage::spec
