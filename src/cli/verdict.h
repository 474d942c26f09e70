// What a run of `selvage verify` found out, as values for the table, for JSON and for JUnit.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "spec/verify.h"

namespace selvage::cli {

// What became of the known violations of a law.
struct Known {
  uint64_t tried = 0;
  std::map<std::string, uint64_t> not_judged{};  // of these, and why
};

struct Verdict {
  spec::LawVerdict found;
  int64_t time_ns = 0;
  std::string picture{};     // where the counterexample was drawn; empty if it was not
  bool from_corpus = false;  // it was known before
  Known known{};
  bool lacked_time = false;    // the time was over before anything was judged, here or in a shard
  std::string in_part{};       // how much of the law is promised; empty: all of it
  std::string not_promised{};  // why it is not, of a law that was asked for all the same
};

// "corpus", "random" or "hunt": what the violation was found by.
[[nodiscard]] std::string_view found_by(const Verdict& verdict);

struct NotPromised {
  std::string law, why;
};

// A function that a library does not export, and the law that is held against it where one does;
// no law of selvage_subject, which tells what is claimed.
struct NotExported {
  std::string function, law;
};

// Part `index` of `count`, from 1 on.
struct Shard {
  uint64_t index = 1, count = 1;
  friend bool operator==(const Shard&, const Shard&) = default;
};

struct VerifyRun {
  std::string subject;
  std::string profile;
  int32_t accuracy_fx16 = 0;           // that the subject claims, in texels
  int32_t coverage_accuracy_fx16 = 0;  // in px
  bool replay = false;                 // one given case instead of generated ones
  uint64_t seed = 0;                   // of the first case; meaningless in a replay
  std::vector<Verdict> verdicts;
  std::vector<NotPromised> not_promised{};  // the laws that were left out for it
  std::vector<NotExported> not_exported{};  // no failure: there is nothing to be held to it
  bool oracle_missing = false;              // this build has no ORACLE law
  std::string arguments{};   // "--subject ./theirs.so ...": how the subject is told again
  uint64_t cases = 0;        // asked for; 0 where a replay or a time was
  uint64_t hunted = 0;       // asked for besides these, of each law
  uint64_t known_cases = 0;  // of the corpus, tried before any other
  std::map<std::string, uint64_t> known_of_others{};  // of these, by law: laws that are not checked
  Shard shard{};
};

// "holds", "violated", "judged nothing": a law without a say has shown nothing, "not judged": there
// was no time for it, or "not promised": it judged nothing because there is nothing.
[[nodiscard]] std::string_view outcome(const Verdict& verdict);

// Every law must hold that is promised, and one at least. In a replay a law may find nothing to
// judge in the one case, but not all; in a shard it may, for other shards have the other cases.
[[nodiscard]] bool passed(const VerifyRun& run);

// Tells of the laws that were asked for in vain, which are not promised and judged nothing.
void note_not_promised(VerifyRun* run);

// 0: passed; 1: not; 3: nothing was found wrong, but for some laws there was no time.
[[nodiscard]] int exit_code(const VerifyRun& run);

// The command that shows the counterexample again.
[[nodiscard]] std::string replay_line(const VerifyRun& run, const Verdict& verdict);
[[nodiscard]] std::string replay_line(const VerifyRun& run, const Verdict& verdict,
                                      const spec::Case& c);

// What else is to be known of a counterexample, a sentence each: that it is not the smallest, or
// that by itself it does not always fail.
[[nodiscard]] std::vector<std::string> notes_on(const Verdict& verdict);

// The largest error: "0.71 of bound", "0 wrong" of an exact law; empty where it does not hold.
[[nodiscard]] std::string margin_text(const Verdict& verdict);

// "subject mine, profile exact, within 1/256 texel".
[[nodiscard]] std::string subject_line(const VerifyRun& run);
// The table, part by part, so that each law can be shown when it is done.
[[nodiscard]] std::string table_header();
[[nodiscard]] std::string table_row(const Verdict& verdict);
[[nodiscard]] std::string table_summary(const VerifyRun& run);
// The violations, each with what to do next.
[[nodiscard]] std::string explanations(const VerifyRun& run);

}  // namespace selvage::cli
