// Which cases a run of `selvage verify` checks, and the checking of them.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "cli/console.h"
#include "cli/corpus.h"
#include "cli/verdict.h"
#include "spec/verify.h"

namespace selvage::cli {

struct VerifyPlan {
  std::vector<const spec::Law*> laws;
  std::optional<spec::Case> replayed;  // this case instead of generated ones
  std::vector<KnownCase> known;        // before generated ones
  uint64_t seed = 0;                   // of case 0
  uint64_t cases = 0;                  // of each law, in all shards together
  uint64_t hunted = 0;                 // besides these, of each law, in all shards together
  Shard shard;                         // cases and climbs index - 1, index - 1 + count, ... are its
  std::optional<std::chrono::nanoseconds> time;          // as many rounds as fit, instead
  bool shrinks = true;                                   // what violates a law
  std::map<const spec::Law*, std::string> not_promised;  // of the laws, and why
};

// "2/8": the second of eight. Throws UserError.
[[nodiscard]] Shard parse_shard(const std::string& text, uint64_t cases);
// A number of cases; if left out none, and without end in a run by time.
[[nodiscard]] uint64_t parse_hunt(const std::string& text, bool by_time);
// Seconds, decimal. Throws UserError.
[[nodiscard]] std::chrono::nanoseconds parse_time(const std::string& text);

// `done` is called with each law's verdict as soon as it is known.
[[nodiscard]] std::vector<Verdict> carry_out(const VerifyPlan& plan, const spec::Subject& subject,
                                             const Console& console,
                                             const std::function<void(const Verdict&)>& done);

}  // namespace selvage::cli
