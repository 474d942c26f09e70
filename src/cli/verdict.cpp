#include "cli/verdict.h"

#include <algorithm>
#include <cstdio>

#include "cli/console.h"
#include "spec/exact.h"

namespace selvage::cli {
namespace {

[[nodiscard]] std::string law_row(std::string_view law, std::string_view verdict,
                                  std::string_view cases, std::string_view judged,
                                  std::string_view margin, std::string_view time) {
  char line[160];
  const auto width = [](std::string_view text) { return static_cast<int>(text.size()); };
  std::snprintf(line, sizeof line, "%-10.*s %-16.*s %10.*s %14.*s %14.*s %10.*s\n", width(law),
                law.data(), width(verdict), verdict.data(), width(cases), cases.data(),
                width(judged), judged.data(), width(margin), margin.data(), width(time),
                time.data());
  return line;
}

[[nodiscard]] std::string time_text(int64_t time_ns) {
  char text[32];
  std::snprintf(text, sizeof text, "%.2f s", static_cast<double>(time_ns) * 1e-9);
  return text;
}

[[nodiscard]] std::string_view shown_outcome(const Verdict& verdict) {
  return verdict.found.violation ? "VIOLATED" : outcome(verdict);
}
// Numbers are decimal, or addresses.
[[nodiscard]] std::string without_numbers(std::string_view text) {
  std::string rest;
  for (size_t i = 0; i < text.size();) {
    const bool is_address = text.substr(i).starts_with("0x");
    const std::string_view digits = is_address ? "0123456789abcdef" : "0123456789";
    const size_t end =
        std::min(text.find_first_not_of(digits, i + (is_address ? 2 : 0)), text.size());
    if (end == i) {
      rest += text[i++];
    } else {
      i = end;
    }
  }
  return rest;
}

// Whichever law made a call that did not end as calls do, it says the same, but for numbers.
[[nodiscard]] bool is_same_call(const spec::Violation& a, const spec::Violation& b) {
  return a.is_of_call && b.is_of_call && a.what == b.what &&
         without_numbers(a.drawn) == without_numbers(b.drawn);
}

[[nodiscard]] std::string explanation(const Verdict& verdict, const spec::Violation* told) {
  const spec::Violation& violation = *verdict.found.violation;
  if (told != nullptr) {
    return "law " + violation.law + " is broken as " + told->law + " is: " + violation.drawn + "\n";
  }
  const std::string text = spec::explain(violation);
  return text + (text.ends_with('\n') ? "" : "\n");
}

}  // namespace

std::string_view outcome(const Verdict& verdict) {
  if (verdict.found.violation) return "violated";
  if (verdict.lacked_time) return "not judged";
  if (verdict.found.judged_px > 0) return "holds";
  return verdict.not_promised.empty() ? "judged nothing" : "not promised";
}

std::string_view found_by(const Verdict& verdict) {
  if (verdict.from_corpus) return "corpus";
  return verdict.found.hunted.found ? "hunt" : "random";
}

bool passed(const VerifyRun& run) {
  if (run.verdicts.empty()) return false;
  const auto is = [](std::string_view which) {
    return [which](const Verdict& verdict) { return outcome(verdict) == which; };
  };
  if (std::any_of(run.verdicts.begin(), run.verdicts.end(), is("violated"))) return false;
  if (std::any_of(run.verdicts.begin(), run.verdicts.end(), is("not judged"))) return false;
  if (run.shard.count > 1) return true;
  if (!run.replay && std::any_of(run.verdicts.begin(), run.verdicts.end(), is("judged nothing")))
    return false;
  return std::any_of(run.verdicts.begin(), run.verdicts.end(), is("holds"));
}

void note_not_promised(VerifyRun* run) {
  for (const Verdict& verdict : run->verdicts) {
    const std::string_view law = verdict.found.law->name;
    std::erase_if(run->not_promised, [&](const NotPromised& other) { return other.law == law; });
    if (outcome(verdict) == "not promised") {
      run->not_promised.push_back({std::string(law), verdict.not_promised});
    }
  }
}

int exit_code(const VerifyRun& run) {
  if (passed(run)) return kExitFine;
  const auto may_hold = [&](const Verdict& verdict) {
    const std::string_view is = outcome(verdict);
    return is == "holds" || is == "not judged" || is == "not promised" ||
           (is == "judged nothing" && run.shard.count > 1);
  };
  const auto lacked_time = [](const Verdict& verdict) { return outcome(verdict) == "not judged"; };
  const bool is_unfinished =
      std::ranges::any_of(run.verdicts, lacked_time) && std::ranges::all_of(run.verdicts, may_hold);
  return is_unfinished && !run.replay ? kExitNoTime : kExitLawFailed;
}

std::string replay_line(const VerifyRun& run, const Verdict& verdict) {
  return replay_line(run, verdict, *verdict.found.counterexample);
}

std::string replay_line(const VerifyRun& run, const Verdict& verdict, const spec::Case& c) {
  return "selvage verify " + run.arguments + (run.arguments.empty() ? "" : " ") + "--law " +
         std::string(verdict.found.law->name) + " --case " + spec::to_hex(c);
}

std::vector<std::string> notes_on(const Verdict& verdict) {
  std::vector<std::string> notes;
  if (!verdict.found.violation) return notes;
  if (!verdict.not_promised.empty()) {
    notes.push_back("the law was asked for, but is not promised: " + verdict.not_promised);
  }
  if (!verdict.found.is_smallest) {
    notes.emplace_back(verdict.found.counterexample == verdict.found.found_case
                           ? "it was not shrunk: this is the counterexample as it was found"
                           : "shrinking was cut short: this is not the smallest counterexample");
  }
  const auto& [tried, failed] = verdict.found.replays;
  if (failed < tried) {
    notes.push_back("it depends on earlier calls or on chance: tried again by itself it failed " +
                    std::to_string(failed) + " of " + std::to_string(tried) +
                    " times, so that the replay may show nothing");
    if (verdict.found.hung) {
      notes.emplace_back("where the machine was the cause, --call-limit gives calls more time");
    }
  }
  return notes;
}

std::string margin_text(const Verdict& verdict) {
  if (outcome(verdict) != "holds") return "";
  if (!verdict.found.margin) return "0 wrong";
  char text[32];
  std::snprintf(text, sizeof text, "%.2f of bound", verdict.found.margin->share());
  return text;
}

std::string subject_line(const VerifyRun& run) {
  std::string line = "subject " + run.subject + ", profile " + run.profile;
  const auto tell = [&](int32_t accuracy_fx16, const char* unit) {
    if (accuracy_fx16 == 0) return;
    spec::Rational accuracy(accuracy_fx16, SELVAGE_SUBTEXELS);
    accuracy.canonicalize();
    line += ", within " + accuracy.get_str() + unit;
  };
  tell(run.accuracy_fx16, " texel");
  tell(run.coverage_accuracy_fx16, " px of its outline");
  return line;
}

std::string table_header() {
  return law_row("law", "verdict", "cases", "pixels judged", "largest error", "time");
}

std::string table_row(const Verdict& verdict) {
  return law_row(verdict.found.law->name, shown_outcome(verdict),
                 std::to_string(verdict.found.cases), std::to_string(verdict.found.judged_px),
                 margin_text(verdict), time_text(verdict.time_ns));
}

std::string explanations(const VerifyRun& run) {
  std::string text;
  std::vector<const spec::Violation*> told;
  for (const Verdict& verdict : run.verdicts) {
    if (!verdict.found.violation) continue;
    const auto same = std::ranges::find_if(told, [&](const spec::Violation* other) {
      return is_same_call(*other, *verdict.found.violation);
    });
    text += "\n" + explanation(verdict, same != told.end() ? *same : nullptr);
    if (same == told.end()) told.push_back(&*verdict.found.violation);
    for (const std::string& note : notes_on(verdict)) text += "note: " + note + "\n";
    text += "replay: " + replay_line(run, verdict) + "\n";
    if (verdict.picture.empty()) continue;
    text += "picture: " + verdict.picture + " (drawn | expected | difference)\n";
  }
  return text;
}

}  // namespace selvage::cli
