// What a run of `selvage verify` found out, as values for the table and for JSON.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "spec/verify.h"

namespace selvage::cli {

struct Verdict {
  spec::LawVerdict found;
  int64_t time_ns = 0;
  std::string picture;  // where the counterexample was drawn; empty if it was not
};

struct VerifyRun {
  std::string subject;
  std::string profile;
  bool replay = false;  // one given case instead of generated ones
  uint64_t seed = 0;    // of the first case; meaningless in a replay
  std::vector<Verdict> verdicts;
  std::vector<std::string> not_promised{};  // "LAW: why", of the laws that were left out for it
  bool oracle_missing = false;              // this build has no ORACLE law
};

// "holds", "violated", or "judged nothing": a law without a say has shown nothing.
[[nodiscard]] std::string_view outcome(const Verdict& verdict);

// Every law must hold. In a replay a law may find nothing to judge in the one case, but not all.
[[nodiscard]] bool passed(const VerifyRun& run);

// The command that shows the counterexample again.
[[nodiscard]] std::string replay_line(const Verdict& verdict);

// The table, part by part, so that each law can be shown when it is done.
[[nodiscard]] std::string table_header();
[[nodiscard]] std::string table_row(const Verdict& verdict);
[[nodiscard]] std::string table_summary(const VerifyRun& run);

[[nodiscard]] std::string verdict_json(const VerifyRun& run);

}  // namespace selvage::cli
