#include "cli/verify_command_line.h"

#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <string>
#include <vector>

#include "cli/subject_command_line.h"

namespace selvage::cli {
namespace {

constexpr const char* kVerifyExamples = R"(Examples:
  selvage verify                               every law on 1000 cases of a fresh seed
  selvage verify --subject ./theirs.so         any library that exports selvage_draw
  selvage verify --subject ./theirs.so --filters nearest --formats rgba8888 --no-perspective
  selvage verify --subject ./theirs.so --position-step 1 --accuracy 1/64   whole pixels, and it rounds
  selvage verify --law MAP --law CLIP --cases 5000 --seed 7
  selvage verify --profile abrash56            what the two-stage DDA of 1992 promises
  selvage verify --cases 1000000 --seed 1 --shard 3/16 --json >3.json   then: selvage merge *.json
  selvage verify --hunt 2000                   besides, climb toward what is hard to draw
  selvage verify --time 600 --corpus known/    as much as fits, known violations first
  selvage verify --law MAP --case 0200...      one case again, as a failure prints it
  selvage verify --case-file crash-1f3a        the same from a fuzzer's raw bytes

A law that found no pixel to judge has shown nothing and counts as failed, unless it was named and
is not promised; in a replay, only if no law found any; in a shard never, for the other shards have
the other cases.
A corpus may be shared: what breaks a law on one subject is tried on all others, as their profile and
claims take it. New violations are added to it, shrunk, a file each, MAP-0123456789abcdef.case; a shard only reads it,
and 'selvage merge --corpus' adds what the shards have found.
A subject runs in a process of its own, so that it may crash, hang or write where it must not: that
is reported as a violation. What it claims, it says by selvage_subject.h, or the command line does.
)";

constexpr const char* kMergeExamples = R"(Examples:
  selvage merge 1.json 2.json 3.json 4.json --junit verdict.xml
of the shards that this has made:
  for i in 1 2 3 4; do selvage verify --seed 1 --cases 4000 --shard $i/4 --json >$i.json; done

All shards of one run are needed. What they knew from a corpus may differ: each violation is one. The verdict is that of the run in one piece, its times are summed.
)";

[[nodiscard]] std::string verdict_footer(const char* examples) {
  return std::string(examples) +
         "\nExit codes: 0 fine; 1 a law failed; 2 wrong use, or a file that cannot be read or "
         "written;\n"
         "3 no violation, but --time was over before each law had judged something.";
}

void add_subject(CLI::App& verify, SubjectOptions& subject) {
  add_library(verify, subject,
              "A shared library that exports selvage_draw; the built-in mapper if left out");
  verify.add_option("--kernel", subject.kernel, "Of the built-in mapper: scalar, avx2, ...")
      ->type_name("NAME")
      ->group(kSubjectGroup);
  verify.add_option("--subject-output", subject.output, "A file for what it prints, up to 1 MiB")
      ->type_name("FILE")
      ->group(kSubjectGroup);
}

// Options of generated cases; returned are those that a replay of one case excludes.
[[nodiscard]] std::vector<CLI::Option*> add_generated(CLI::App& verify, VerifyOptions& options) {
  CLI::Option* profile =
      verify
          .add_option("--profile", options.profile,
                      "The profile to hold it to: exact (the default), abrash56, abrash57 or dkit")
          ->type_name("NAME");
  CLI::Option* cases = verify.add_option("--cases", options.cases, "Cases for each law")
                           ->type_name("N")
                           ->capture_default_str();
  CLI::Option* hunt =
      verify
          .add_option("--hunt", options.hunt,
                      "Hunted cases for each law, besides: climbs toward ties and larger errors; "
                      "none if left out, but as many as fit with --time")
          ->type_name("N");
  CLI::Option* seed =
      verify.add_option("--seed", options.seed, "Seed of the first case; a fresh one if left out")
          ->type_name("S");
  CLI::Option* shard = verify
                           .add_option("--shard", options.shard,
                                       "Every Nth case alone, from the Ith on, for a part "
                                       "of a run; wants --seed")
                           ->type_name("I/N")
                           ->needs(seed);
  CLI::Option* time =
      verify.add_option("--time", options.time, "As many cases as fit, the laws in turn")
          ->type_name("SECONDS")
          ->excludes(cases, shard);
  CLI::Option* corpus = verify
                            .add_option("--corpus", options.corpus,
                                        "Known violations: tried first; new ones are written there "
                                        "(with --shard: by merge). Made if it is missing, but not "
                                        "what is above it")
                            ->type_name("DIR");
  return {cases, hunt, seed, profile, time, shard, corpus};
}

void add_cases(CLI::App& verify, VerifyOptions& options) {
  const std::vector<CLI::Option*> generated = add_generated(verify, options);
  CLI::Option* hex =
      verify.add_option("--case", options.case_hex, "Replay this one case")->type_name("HEX");
  CLI::Option* file =
      verify.add_option("--case-file", options.case_file, "Replay the case of these raw bytes")
          ->type_name("FILE")
          ->excludes(hex);
  for (CLI::Option* option : generated) {
    hex->excludes(option);
    file->excludes(option);
  }
}

}  // namespace

CLI::App* add_verify(CLI::App& program, VerifyOptions& options) {
  CLI::App* verify = program.add_subcommand("verify", "Hold a mapper against the laws");
  verify
      ->add_option("--law", options.laws,
                   "A law to check; all that the subject promises if left out. May be repeated")
      ->type_name("NAME")
      ->allow_extra_args(false);
  add_cases(*verify, options);
  verify
      ->add_option("--picture", options.picture,
                   "PNG for the counterexample (drawn | expected | difference), of a second law "
                   "and on with the law in its name; selvage-<law>.png if left out")
      ->type_name("FILE");
  verify->add_flag_callback(
      "--no-picture", [&options] { options.draws_pictures = false; }, "Write no pictures");
  verify->add_flag_callback(
      "--no-shrink", [&options] { options.shrinks = false; },
      "Tell counterexamples as they were found, not the smallest ones");
  verify->add_flag("--json", options.json, "Print the verdicts as JSON");
  verify->add_option("--junit", options.junit, "Write them as JUnit XML, too")->type_name("FILE");
  add_subject(*verify, options.subject);
  add_claims(*verify, options.subject);
  verify->footer(verdict_footer(kVerifyExamples));
  return verify;
}

CLI::App* add_merge(CLI::App& program, MergeOptions& options) {
  CLI::App* merge = program.add_subcommand("merge", "Add up the shards of a run of verify");
  merge->add_option("FILES", options.files, "What 'verify --shard I/N --json' has printed")
      ->required()
      ->type_name("FILE");
  merge
      ->add_option("--corpus", options.corpus,
                   "The shards' corpus, which they only read: what is new is written there")
      ->type_name("DIR");
  merge->add_flag("--json", options.json, "Print the verdict as JSON");
  merge->add_option("--junit", options.junit, "Write it as JUnit XML, too")->type_name("FILE");
  merge->footer(verdict_footer(kMergeExamples));
  return merge;
}

}  // namespace selvage::cli
