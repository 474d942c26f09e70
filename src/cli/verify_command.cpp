#include "cli/verify_command.h"

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "cli/counterexample_picture.h"
#include "cli/error.h"
#include "cli/file.h"
#include "cli/job.h"
#include "cli/png.h"
#include "cli/seeds.h"
#include "cli/status_line.h"
#include "cli/verdict.h"
#include "spec/profiles.h"

namespace selvage::cli {
namespace {

constexpr size_t kMaxCaseBytes = size_t{1} << 20;

[[nodiscard]] const spec::Law& find_law(const std::string& name) {
  std::string upper = name;
  std::transform(upper.begin(), upper.end(), upper.begin(), [](char letter) {
    return letter >= 'a' && letter <= 'z' ? static_cast<char>(letter - 'a' + 'A') : letter;
  });
  if (const spec::Law* law = spec::find_law(upper)) return *law;
  std::string known;
  for (const spec::Law& law : spec::laws()) known += " " + std::string(law.name);
  throw UserError("--law: no law is called '" + name + "'; the laws are" + known);
}

// Those that were named, or all that the profile promises.
[[nodiscard]] std::vector<const spec::Law*> chosen_laws(const std::vector<std::string>& names,
                                                        selvage_profile profile) {
  std::vector<const spec::Law*> chosen;
  for (const std::string& name : names) {
    const spec::Law* law = &find_law(name);
    if (std::find(chosen.begin(), chosen.end(), law) == chosen.end()) chosen.push_back(law);
  }
  if (names.empty()) {
    for (const spec::Law& law : spec::laws()) {
      if (spec::is_promised(profile, law.name)) chosen.push_back(&law);
    }
  }
  return chosen;
}

[[nodiscard]] std::vector<std::string> unpromised_laws(selvage_profile profile) {
  std::vector<std::string> unpromised;
  for (const spec::Law& law : spec::laws()) {
    const spec::Promise promise = spec::promise(profile, law.name);
    if (promise.standing != spec::Standing::kNotPromised) continue;
    unpromised.push_back(std::string(law.name) + ": " + std::string(promise.note));
  }
  return unpromised;
}

[[nodiscard]] std::optional<spec::Case> case_to_replay(const VerifyOptions& options) {
  if (!options.case_file.empty()) {
    return spec::decode(read_file(options.case_file, kMaxCaseBytes));
  }
  if (options.case_hex.empty()) return std::nullopt;
  std::optional<spec::Case> replayed = spec::from_hex(options.case_hex);
  if (!replayed) {
    throw UserError("--case: an even number of hexadecimal digits is needed, as verify prints it");
  }
  return replayed;
}

[[nodiscard]] spec::LawVerdict replay(const spec::Law& law, const spec::Subject& subject,
                                      const spec::Case& c) {
  spec::Judgement judgement = law.check(subject, c);
  spec::LawVerdict verdict{&law, 1, judgement.judged_px, std::move(judgement.violation), {}};
  if (verdict.violation) verdict.counterexample = c;
  return verdict;
}

[[nodiscard]] Verdict timed(const std::function<spec::LawVerdict()>& check) {
  const auto start = std::chrono::steady_clock::now();
  Verdict verdict;
  verdict.found = check();
  verdict.time_ns = std::chrono::nanoseconds(std::chrono::steady_clock::now() - start).count();
  return verdict;
}

// The first picture takes the name that was asked for, later ones put their law in front of the
// extension.
[[nodiscard]] std::string picture_name(const VerifyOptions& options, const std::string& law,
                                       bool first) {
  if (options.picture.empty()) return "selvage-" + law + ".png";
  if (first) return options.picture;
  const std::filesystem::path asked(options.picture);
  return (asked.parent_path() / (asked.stem().string() + "-" + law + asked.extension().string()))
      .string();
}

// A picture that cannot be written is no reason to lose the verdict: it is reported beside it.
void write_pictures(const VerifyOptions& options, const spec::Subject& subject, VerifyRun& run,
                    const Console& console) {
  bool first = true;
  for (Verdict& verdict : run.verdicts) {
    if (!verdict.found.violation) continue;
    const std::string name =
        picture_name(options, std::string(verdict.found.law->name), std::exchange(first, false));
    try {
      write_file(name, encode_png(counterexample_picture(subject, *verdict.found.violation)));
      verdict.picture = name;
    } catch (const UserError& error) {
      console.err << "selvage: no picture of the violation: " << error.what() << '\n';
    }
  }
}

void explain_violations(const VerifyRun& run, const Console& console) {
  for (const Verdict& verdict : run.verdicts) {
    if (!verdict.found.violation) continue;
    const std::string explanation = spec::explain(*verdict.found.violation);
    console.out << '\n' << explanation << (explanation.ends_with('\n') ? "" : "\n");
    console.out << "replay: " << replay_line(verdict) << '\n';
    if (verdict.picture.empty()) continue;
    console.out << "picture: " << verdict.picture << " (drawn | expected | difference)\n";
  }
}

// Checks one law in the way of this run: on the given case or on generated ones.
using Check = std::function<spec::LawVerdict(const spec::Law&)>;

[[nodiscard]] std::vector<Verdict> check_all(const std::vector<const spec::Law*>& laws,
                                             const Check& check, bool show_rows,
                                             const Console& console) {
  std::vector<Verdict> verdicts;
  if (show_rows) console.out << table_header() << std::flush;
  for (const spec::Law* law : laws) {
    verdicts.push_back(timed([&] { return check(*law); }));
    if (show_rows) console.out << table_row(verdicts.back()) << std::flush;
  }
  return verdicts;
}

}  // namespace

int run_verify(const VerifyOptions& options, const spec::Subject& mapper, const Console& console) {
  const uint64_t cases = case_count(options.cases);
  const std::optional<spec::Case> replayed = case_to_replay(options);
  spec::Subject subject = mapper;
  subject.profile = replayed ? replayed->profile
                             : about("--profile", [&] { return parse_profile(options.profile); });
  const std::vector<const spec::Law*> laws = chosen_laws(options.laws, subject.profile);
  if (!options.picture.empty()) check_output(options.picture);
  VerifyRun run{.subject = subject.name,
                .profile = std::string(spec::profile_of(subject.profile).name),
                .replay = replayed.has_value(),
                .seed = first_seed(options.seed),
                .verdicts = {}};
  if (options.laws.empty()) run.not_promised = unpromised_laws(subject.profile);
  run.oracle_missing = options.laws.empty() && spec::find_law("ORACLE") == nullptr;
  const auto check = [&](const spec::Law& law) {
    if (replayed) return replay(law, subject, *replayed);
    StatusLine status(console);
    return spec::verify(law, subject, run.seed, cases,
                        [&](uint64_t done) { status.count(law.name, done, cases); });
  };

  const bool show = !options.json;
  if (show && replayed) console.out << spec::print(*replayed) << '\n';
  if (show && !replayed) console.out << "seed " << run.seed << '\n';
  run.verdicts = check_all(laws, check, show, console);
  if (show) console.out << table_summary(run);
  write_pictures(options, subject, run, console);
  if (show) explain_violations(run, console);
  if (!show) console.out << verdict_json(run);
  return passed(run) ? kExitFine : kExitLawFailed;
}

}  // namespace selvage::cli
