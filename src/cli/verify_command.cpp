#include "cli/verify_command.h"

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <utility>

#include "cli/corpus.h"
#include "cli/counterexample_picture.h"
#include "cli/error.h"
#include "cli/file.h"
#include "cli/junit.h"
#include "cli/picture_output.h"
#include "cli/png.h"
#include "cli/seeds.h"
#include "cli/verdict.h"
#include "cli/verdict_json.h"
#include "cli/verify_plan.h"
#include "spec/profiles.h"
#include "spec/promise.h"

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

// Those that were named, or all that the subject promises.
[[nodiscard]] std::vector<const spec::Law*> chosen_laws(const std::vector<std::string>& names,
                                                        const spec::Subject& subject) {
  std::vector<const spec::Law*> chosen;
  for (const std::string& name : names) {
    const spec::Law* law = &find_law(name);
    if (std::find(chosen.begin(), chosen.end(), law) == chosen.end()) chosen.push_back(law);
  }
  if (!names.empty()) return chosen;
  for (const spec::Law& law : spec::laws()) {
    const spec::Promise promise = spec::promise(subject.profile, subject.claims, law.name);
    if (promise.standing == spec::Standing::kPromised) chosen.push_back(&law);
  }
  return chosen;
}

// Of the laws that were named those that are not promised, and why.
[[nodiscard]] std::map<const spec::Law*, std::string> named_in_vain(
    const std::vector<const spec::Law*>& laws, const spec::Subject& subject) {
  std::map<const spec::Law*, std::string> unpromised;
  for (const spec::Law* law : laws) {
    const spec::Promise promise = spec::promise(subject.profile, subject.claims, law->name);
    if (promise.standing != spec::Standing::kPromised) unpromised[law] = promise.note;
  }
  return unpromised;
}

[[nodiscard]] std::vector<NotPromised> unpromised_laws(const spec::Subject& subject) {
  std::vector<NotPromised> unpromised;
  for (const spec::Law& law : spec::laws()) {
    const spec::Promise promise = spec::promise(subject.profile, subject.claims, law.name);
    if (promise.standing != spec::Standing::kNotPromised) continue;
    unpromised.push_back({std::string(law.name), std::string(promise.note)});
  }
  return unpromised;
}

[[nodiscard]] char lower(char digit) {
  return digit >= 'A' && digit <= 'F' ? static_cast<char>(digit - 'A' + 'a') : digit;
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
  const std::string digits = spec::to_hex(*replayed);
  const auto is_same = [](char one, char two) { return lower(one) == lower(two); };
  if (!std::ranges::equal(digits, options.case_hex, is_same)) {
    throw UserError("--case: the " + std::to_string(options.case_hex.size()) +
                    " digits are no whole case as verify prints it, but one that was cut off, "
                    "lengthened or changed; the case that they come nearest to is " +
                    digits);
  }
  return replayed;
}

// The first picture takes the name that was asked for, later ones put their law in front of the
// extension.
[[nodiscard]] std::string picture_name(const VerifyOptions& options, const std::string& law,
                                       const Shard& shard, bool first) {
  const std::string part =
      shard.count > 1 ? "-" + std::to_string(shard.index) + "of" + std::to_string(shard.count) : "";
  if (options.picture.empty()) return "selvage-" + law + part + ".png";
  if (first) return options.picture;
  const std::filesystem::path asked(options.picture);
  return (asked.parent_path() / (asked.stem().string() + "-" + law + asked.extension().string()))
      .string();
}

// Thrown by a drawing for a picture alone, where the time of the run is over.
struct OutOfTime {};

// A subject that hangs would take the time of a call for each.
[[nodiscard]] spec::Subject for_pictures(const spec::Subject& subject, bool hangs) {
  spec::Subject patient = subject;
  if (hangs) patient.draw = [](auto...) -> selvage_status { throw OutOfTime{}; };
  return patient;
}

// A picture that cannot be written is no reason to lose the verdict: it is reported beside it.
void write_pictures(const VerifyOptions& options, const spec::Subject& subject, VerifyRun& run,
                    const Console& console) {
  bool first = true;
  for (Verdict& verdict : run.verdicts) {
    if (!verdict.found.violation) continue;
    const std::string name =
        picture_name(options, std::string(verdict.found.law->name), run.shard, first);
    try {
      const PictureComparison seen =
          counterexample(subject, *verdict.found.violation, verdict.found.drawings.get());
      if (!differs(seen)) continue;  // what was wrong lies outside of the picture
      write_file(name, encode_png(comparison_picture(seen)));
      first = false;
      verdict.picture = name;
    } catch (const OutOfTime&) {
    } catch (const spec::NotClaimed&) {  // an outline that the subject draws in tiles alone
    } catch (const UserError& error) {
      console.err << "selvage: no picture of the violation: " << error.what() << '\n';
    }
  }
}

[[nodiscard]] VerifyPlan plan_of(const VerifyOptions& options, const spec::Subject& subject,
                                 std::optional<spec::Case> replayed, const Console& console) {
  VerifyPlan plan;
  plan.laws = chosen_laws(options.laws, subject);
  plan.not_promised = named_in_vain(plan.laws, subject);
  plan.replayed = std::move(replayed);
  plan.shrinks = options.shrinks;
  plan.seed = first_seed(options.seed);
  plan.cases = case_count(options.cases);
  plan.shard = parse_shard(options.shard, plan.cases);
  if (!options.time.empty()) plan.time = parse_time(options.time);
  plan.hunted = parse_hunt(options.hunt, plan.time.has_value());
  if (!options.corpus.empty() && !plan.replayed) {
    check_corpus(options.corpus);
    // Shards only read what there is; merge makes it, and adds what they find.
    if (plan.shard.count == 1) make_corpus(options.corpus, console);
    if (std::filesystem::exists(options.corpus)) plan.known = read_corpus(options.corpus);
  }
  return plan;
}

// Calls that laws which are checked would be held against, if the library had them, and the one
// that tells its claims.
[[nodiscard]] std::vector<NotExported> not_exported(const ChosenSubject& chosen,
                                                    const VerifyPlan& plan) {
  const spec::Subject& subject = chosen.subject;
  std::vector<NotExported> missing;
  if (!chosen.host->tells_claims()) missing.push_back({"selvage_subject", ""});
  const auto note = [&](bool has, const char* function, const char* law) {
    const auto is_it = [law](const spec::Law* one) { return one->name == law; };
    if (!has && std::ranges::any_of(plan.laws, is_it)) missing.push_back({function, law});
  };
  note(subject.draw_many != nullptr, "selvage_draw_many", "SAME");
  note(subject.prepare.has_value(), "selvage_prepare", "SAME");
  note(subject.choose != nullptr, "selvage_choose", "TOLERANCE");
  return missing;
}

[[nodiscard]] VerifyRun begun(const VerifyOptions& options, const ChosenSubject& chosen,
                              const VerifyPlan& plan) {
  VerifyRun run{.subject = chosen.subject.name,
                .profile = std::string(spec::profile_of(chosen.subject.profile).name),
                .accuracy_fx16 = chosen.subject.claims.accuracy_fx16,
                .coverage_accuracy_fx16 = chosen.subject.claims.coverage_accuracy_fx16,
                .replay = plan.replayed.has_value(),
                .seed = plan.seed,
                .verdicts = {}};
  if (options.laws.empty()) run.not_promised = unpromised_laws(chosen.subject);
  if (chosen.host) run.not_exported = not_exported(chosen, plan);
  run.oracle_missing = options.laws.empty() && spec::find_law("ORACLE") == nullptr;
  run.arguments = chosen.arguments;
  run.cases = plan.replayed || plan.time ? 0 : plan.cases;
  run.hunted = plan.replayed || plan.time ? 0 : plan.hunted;
  run.known_cases = plan.known.size();
  for (const KnownCase& known : plan.known) {
    const bool checked =
        std::ranges::any_of(plan.laws, [&](const auto* law) { return law->name == known.law; });
    if (!checked) ++run.known_of_others[known.law];
  }
  run.shard = plan.shard;
  return run;
}

void show_beginning(const VerifyOptions& options, const VerifyRun& run, const VerifyPlan& plan,
                    const Console& console) {
  if (!run.arguments.empty()) console.out << subject_line(run) << '\n';  // not all defaults
  if (plan.replayed) console.out << spec::print(*plan.replayed) << '\n';
  if (!plan.replayed) console.out << "seed " << run.seed << '\n';
  if (!options.corpus.empty()) {
    console.out << "corpus " << run.known_cases << " known cases\n";
  }
  console.out << table_header() << std::flush;
}

// What a subject prints would be lost, or stand between the lines of the verdict.
void keep_output(const VerifyOptions& options, const ChosenSubject& chosen,
                 const Console& console) {
  if (!chosen.host) return;
  const std::string printed = chosen.host->printed();
  if (!options.subject.output.empty()) {
    write_text_file(options.subject.output, printed);
  } else if (!printed.empty()) {
    console.err << "selvage: the subject has printed " << printed.size()
                << " bytes; --subject-output FILE keeps them\n";
  }
}

}  // namespace

int run_verify(const VerifyOptions& options, const spec::Subject& built_in,
               const Console& console) {
  const std::optional<spec::Case> replayed = case_to_replay(options);
  ChosenSubject chosen = choose_subject(options.subject, options.profile, built_in);
  if (replayed) chosen.subject.profile = replayed->profile;
  demand_exact_profile(chosen.subject);
  if (!options.picture.empty()) check_picture(options.picture, PictureKinds::kFiles, console);
  for (const std::string& file : {options.junit, options.subject.output}) {
    if (!file.empty()) check_output(file);
  }
  const VerifyPlan plan = plan_of(options, chosen.subject, replayed, console);
  VerifyRun run = begun(options, chosen, plan);
  const bool show = !options.json;
  if (show) show_beginning(options, run, plan, console);
  run.verdicts = carry_out(plan, chosen.subject, console, [&](const Verdict& verdict) {
    if (show) console.out << table_row(verdict) << std::flush;
  });
  note_not_promised(&run);
  if (show) console.out << table_summary(run);
  const bool hangs =
      std::ranges::any_of(run.verdicts, [](const Verdict& verdict) { return verdict.found.hung; });
  if (options.draws_pictures) {
    write_pictures(options, for_pictures(chosen.subject, hangs && plan.time), run, console);
  }
  if (run.shard.count == 1) add_to_corpus(options.corpus, run);
  if (!options.junit.empty()) write_text_file(options.junit, junit_xml(run));
  console.out << (show ? explanations(run) : verdict_json(run));
  keep_output(options, chosen, console);
  return exit_code(run);
}

}  // namespace selvage::cli
