#include "cli/command_line.h"

#include <sstream>

#include "cli/png.h"
#include "sample_pictures.h"
#include "selvage.h"
#include "support.h"
#include "wrong_subjects.h"

namespace selvage::cli::test {
namespace {

using Words = std::vector<std::string>;

struct Outcome {
  int code;
  std::string out, err;
};

[[nodiscard]] Outcome run(Words arguments, const spec::Subject& subject = spec::built_in()) {
  std::ostringstream out, err;
  const int code = run_program(std::move(arguments), subject, {out, err});
  return {code, out.str(), err.str()};
}

// A usage error: code 2, a message that contains `part`, nothing on the standard output.
void expect_refused(const Words& arguments, const std::string& part) {
  const Outcome outcome = run(arguments);
  EXPECT_EQ(outcome.code, kExitUsage);
  EXPECT_EQ(outcome.out, "");
  EXPECT_EQ(outcome.err.rfind("selvage: ", 0), 0u) << outcome.err;
  expect_contains(outcome.err, part);
}

class CommandLine : public InDirectory {
 protected:
  CommandLine() { put("texture.png", encode_png(sample_raster(8, 8))); }
  const Words draw_ = {"draw",   "--texture", "texture.png", "--polygon", "0,0,0,0 9,0,8,0 0,9,0,8",
                       "--size", "16x16",     "-o",          "out.png"};
  [[nodiscard]] Words draw_and(const Words& more) const {
    Words words = draw_;
    words.insert(words.end(), more.begin(), more.end());
    return words;
  }
};

TEST_F(CommandLine, TellsItsVersion) {
  const Outcome outcome = run({"--version"});
  EXPECT_EQ(outcome.code, kExitFine);
  EXPECT_EQ(outcome.out, std::string("selvage ") + selvage_version() + "\n");
}

TEST_F(CommandLine, HelpsWithExamplesForEveryCommand) {
  for (const char* command : {"", "draw", "verify", "merge", "laws"}) {
    Words words = {"--help"};
    if (*command != 0) words.insert(words.begin(), command);
    const Outcome outcome = run(words);
    EXPECT_EQ(outcome.code, kExitFine);
    EXPECT_EQ(outcome.err, "");
    expect_contains(outcome.out, "Examples:\n  selvage " + std::string(command));
  }
}

// Each its own, in one list.
TEST_F(CommandLine, HelpsWithTheExitCodesOfEachCommand) {
  const std::string fine = "Exit codes: 0 fine; ";
  const std::string use = "2 wrong use, or a file that cannot be read or written";
  const std::string verdict =
      fine + "1 a law failed; " + use +
      ";\n3 no violation, but --time was over before each law had judged something.\n";
  const std::pair<Words, std::string> all[] = {
      {{"draw"}, fine + use + ".\n"},
      {{"laws"}, fine + use + ".\n"},
      {{"verify"}, verdict},
      {{"merge"}, verdict},
      {{"render"}, fine + use + ".\n"},
      {{}, "3 there was no time for each law\n(verify, merge).\n"}};
  for (const auto& [command, codes] : all) {
    Words words = command;
    words.emplace_back("--help");
    const std::string out = run(words).out;
    const size_t list = out.find("Exit codes: ");
    ASSERT_NE(list, std::string::npos);
    expect_contains(out.substr(list), codes);
  }
}

TEST_F(CommandLine, HelpsWithStability) {
  const Outcome outcome = run({"stability", "--help"});
  EXPECT_EQ(outcome.code, kExitFine);
  expect_contains(outcome.out, "Examples:\n  selvage stability");
  expect_contains(outcome.out, "Exit codes: 0 fine; 1 a promise is broken");
}

TEST_F(CommandLine, WithoutACommandSaysWhatIsPossible) {
  expect_refused({}, "Run 'selvage --help'");
  expect_refused({"paint"}, "Run 'selvage --help'");
  expect_refused({"draw", "laws"}, "Run 'selvage");
}

TEST_F(CommandLine, NamesAWordThatIsNoCommand) {
  const std::string commands = "; draw, render, demo, verify, merge, stability, bench and laws are";
  const std::string help = "\nRun 'selvage --help' for what is possible.\n";
  const auto said = [](const Words& words) { return run(words).err; };
  EXPECT_EQ(said({"foo"}), "selvage: 'foo' is no command" + commands + help);
  for (const char* word : {"drw", "rdaw", "drawn", "crew", "drawl"}) {
    EXPECT_EQ(run({word}).code, kExitUsage);
    expect_contains(said({word, "--texture", "x"}), "'" + std::string(word) + "' is no command");
  }
  for (const char* near : {"drw", "rdaw", "drawn", "draq"})
    expect_contains(said({near}), ". Is 'draw' meant?" + help);
  EXPECT_EQ(said({"crew"}).find("meant"), std::string::npos);
  expect_refused({"--blur", "foo"}, "The following arguments were not expected: --blur foo\n");
}

TEST_F(CommandLine, ListsWhatItDidNotExpectAsItWasGiven) {
  expect_refused(draw_and({"--polygonn", "0", "--blur"}),
                 "selvage: The following arguments were not expected: --polygonn 0 --blur\n");
  expect_refused(
      {"draw", "--texture", "texture.png", "--ouput", "out.png"},
      "--output is required. The following arguments were not expected: --ouput out.png");
}

TEST_F(CommandLine, RefusesUnknownAndMissingOptions) {
  expect_refused(draw_and({"--blur"}), "--blur");
  expect_refused(draw_and({"stray"}), "stray");
  expect_refused({"draw"}, "--texture is required");
  expect_refused({"draw"}, "Run 'selvage draw --help'");
  expect_refused({"draw", "--texture", "texture.png", "--polygon", "0,0,0,0 9,0,8,0 0,9,0,8"},
                 "--output is required");
  expect_refused(draw_and({"--clip"}), "--clip");
  expect_refused(draw_and({"--format", ""}), "--format is given without a value");
}

TEST_F(CommandLine, RefusesOptionsThatExcludeEachOther) {
  expect_refused(draw_and({"--polygon-file", "job.json"}), "--polygon excludes --polygon-file");
  expect_refused({"verify", "--case", "00", "--seed", "1"}, "excludes");
  expect_refused({"verify", "--case", "00", "--cases", "1"}, "excludes");
  expect_refused({"verify", "--case", "00", "--case-file", "x"}, "excludes");
  expect_refused({"verify", "--case-file", "x", "--seed", "1"}, "excludes");
  for (const char* other : {"--list", "--brief", "--curves"})
    expect_refused({"bench", "--near-ties", "9", other}, "excludes");
  expect_refused({"bench", "--near-ties", "9", "--filter", "W1"}, "excludes");
}

TEST_F(CommandLine, RefusesAnOptionGivenTwice) {
  expect_refused(draw_and({"--size", "3x3"}), "--size");
  expect_refused({"verify", "--seed", "1", "--seed", "2"}, "--seed");
}

TEST_F(CommandLine, Draws) {
  const Outcome outcome = run(draw_);
  EXPECT_EQ(outcome.code, kExitFine) << outcome.err;
  EXPECT_EQ(outcome.out + outcome.err, "");
  EXPECT_EQ(files(), (Words{"out.png", "texture.png"}));
}

TEST_F(CommandLine, TakesSeveralPolygonsAndNegativeNumbers) {
  const Outcome outcome =
      run(draw_and({"--polygon", "-5,-5,0,0 3,-5,8,0 3,3,8,8", "--polygon=-1,0,0,0 2,0,0,0 2,2,0,0",
                    "--clip", "-3,-3,10,10", "--json"}));
  EXPECT_EQ(outcome.code, kExitFine) << outcome.err;
  expect_contains(outcome.out, "\"polygons\": 3");
}

TEST_F(CommandLine, NamesABadFileAndExitsWithTwo) {
  expect_refused({"draw", "--texture", "none.png", "--polygon", "0,0,0,0 9,0,8,0 0,9,0,8", "--size",
                  "9x9", "-o", "out.png"},
                 "selvage: cannot read 'none.png': No such file or directory\n");
  EXPECT_EQ(files(), Words{"texture.png"});
}

TEST_F(CommandLine, Verifies) {
  const Words words = {"verify", "--law", "MAP", "--law", "COV", "--cases", "20", "--seed", "3"};
  EXPECT_EQ(run(words).code, kExitFine);
  const Outcome outcome = run(words, blank());
  EXPECT_EQ(outcome.code, kExitLawFailed);
  expect_contains(outcome.out, "COV        VIOLATED");
}

TEST_F(CommandLine, TakesEitherNameOfAFormatEverywhere) {
  for (const char* name : {"index8", "grey8"}) {
    EXPECT_EQ(run(draw_and({"--format", name})).code, kExitFine);
    EXPECT_EQ(
        run({"verify", "--law", "COV", "--cases", "2", "--seed", "3", "--formats", name}).code,
        kExitFine);
  }
  const std::string known = ": 'grey' is no format; rgba8888, rgb565 and index8 are";
  expect_refused(draw_and({"--format", "grey"}), "--format" + known);
  expect_refused({"verify", "--formats", "grey"}, "--formats" + known);
}

TEST_F(CommandLine, MeasuresStability) {
  const Words words = {"stability", "--arithmetic", "exact", "--cases", "1", "--seed", "3"};
  EXPECT_EQ(run(words).code, kExitFine);
  EXPECT_EQ(run(words, blank()).code, kExitLawFailed);
  EXPECT_EQ(run({"stability", "--list"}).code, kExitFine);
  expect_refused({"stability", "--family", "NOPE"}, "no hard family is called 'NOPE'");
}

TEST_F(CommandLine, ListsTheLaws) {
  EXPECT_EQ(run({"laws"}).code, kExitFine);
  expect_contains(run({"laws", "--json"}).out, "\"law\": \"COV\"");
}

TEST_F(CommandLine, ReportsASubjectThatThrows) {
  const spec::Subject thrower{
      "thrower",
      [](const selvage_image*, const selvage_rect*, const selvage_vertex*, size_t,
         const selvage_texture*,
         const selvage_options*) -> selvage_status { throw std::runtime_error("torn"); }};
  const Outcome outcome = run({"verify", "--law", "COV"}, thrower);
  EXPECT_EQ(outcome.code, kExitUsage);
  EXPECT_EQ(outcome.err, "selvage: torn\n");
}

}  // namespace
}  // namespace selvage::cli::test
