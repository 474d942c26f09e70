// What a run found out, in some lines under the table.
#include <algorithm>
#include <cstdio>
#include <map>

#include "cli/verdict.h"

namespace selvage::cli {
namespace {

[[nodiscard]] std::string score_text(const spec::Score& score) {
  char text[48];
  if (score.share > 0) {
    std::snprintf(text, sizeof text, "%.2f of bound", score.share);
  } else {
    std::snprintf(text, sizeof text, "%.2f of the closeness there can be", score.closeness);
  }
  return text;
}

// What the hunts came to, a line for each law that was hunted for.
[[nodiscard]] std::string hunt_summary(const VerifyRun& run) {
  std::string text;
  for (const Verdict& verdict : run.verdicts) {
    const spec::Hunted& hunted = verdict.found.hunted;
    if (hunted.cases == 0) continue;
    text += "hunted: " + std::string(verdict.found.law->name) + ": " +
            std::to_string(hunted.cases) + " cases";
    if (hunted.found) text += ", the last a violation";
    if (hunted.best) text += ", the best " + score_text(*hunted.best);
    text += "\n";
  }
  return text;
}

// The known cases that say nothing about this subject.
[[nodiscard]] std::string known_summary(const VerifyRun& run) {
  std::string text;
  const auto tell = [&](const std::string& law, uint64_t cases, const std::string& why) {
    text += "known, not judged: " + law + ": " + std::to_string(cases) + " cases: " + why + "\n";
  };
  for (const Verdict& verdict : run.verdicts) {
    for (const auto& [why, cases] : verdict.known.not_judged) {
      tell(std::string(verdict.found.law->name), cases, why);
    }
  }
  for (const auto& [law, cases] : run.known_of_others) tell(law, cases, "the law is not checked");
  return text;
}

// A line for each of the reasons, which most laws share.
using LawsByReason = std::map<std::string, std::string>;
[[nodiscard]] std::string reason_lines(const char* kind, const LawsByReason& laws) {
  std::string text;
  for (const auto& [why, which] : laws) text += std::string(kind) + ": " + why + ":" + which + "\n";
  return text;
}

[[nodiscard]] std::string claims_summary(const VerifyRun& run) {
  LawsByReason laws;
  for (const Verdict& verdict : run.verdicts) {
    for (const auto& [what, cases] : verdict.found.not_claimed) {
      laws[what] += " " + std::string(verdict.found.law->name) + " in " + std::to_string(cases) +
                    " of " + std::to_string(verdict.found.cases) + " cases,";
    }
  }
  for (auto& [what, which] : laws) which.pop_back();
  return reason_lines("not claimed", laws);
}

[[nodiscard]] std::string parts_summary(const VerifyRun& run) {
  LawsByReason laws;
  for (const Verdict& verdict : run.verdicts) {
    if (!verdict.in_part.empty()) {
      laws[verdict.in_part] += " " + std::string(verdict.found.law->name);
    }
  }
  return reason_lines("in part", laws);
}

}  // namespace

std::string table_summary(const VerifyRun& run) {
  const auto count = [&](std::string_view which) {
    return std::count_if(run.verdicts.begin(), run.verdicts.end(),
                         [&](const Verdict& verdict) { return outcome(verdict) == which; });
  };
  std::string text =
      run.oracle_missing ? "ORACLE is not in this build, which found no OpenCV.\n" : "";
  text +=
      std::to_string(count("holds")) + " of " + std::to_string(run.verdicts.size()) + " laws hold";
  if (const auto n = count("violated")) text += ", " + std::to_string(n) + " violated";
  if (const auto n = count("judged nothing")) {
    text += ", " + std::to_string(n) + " judged nothing";
    text += run.replay            ? " in this case"
            : run.shard.count > 1 ? " in this shard"
                                  : ", which shows nothing and counts as a failure";
  }
  if (const auto n = count("not promised")) text += ", " + std::to_string(n) + " not promised";
  if (const auto n = count("not judged")) {
    text += ", " + std::to_string(n) + " not judged: the time was over (more --time is needed)";
  }
  text += ".\n";
  text += claims_summary(run) + hunt_summary(run) + known_summary(run) + parts_summary(run);
  for (const NotPromised& law : run.not_promised) {
    text += "not promised: " + law.law + ": " + law.why + "\n";
  }
  for (const auto& [function, law] : run.not_exported) {
    text += "not exported: " + function + ": " +
            (law.empty() ? "what it claims is told by the command line, or is all of its profile"
                         : law + " says nothing of it") +
            "\n";
  }
  return text;
}

}  // namespace selvage::cli
