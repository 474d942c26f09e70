#include "cli/verdict.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "support.h"

namespace selvage::cli::test {
namespace {

[[nodiscard]] Verdict holding(const char* law, uint64_t judged_px = 100) {
  return {{spec::find_law(law), 20, judged_px, {}, {}}, 1'500'000'000, {}};
}

[[nodiscard]] Verdict violated(const char* law) {
  spec::Violation violation;
  violation.law = law;
  violation.what = "it should have held";
  violation.x_px = 3;
  violation.y_px = 4;
  violation.u = "7/2";
  violation.allowed = "texel (3, 0)";
  violation.drawn = "texel (4, 0)";
  return {{spec::find_law(law), 7, 55, violation, spec::Case{}}, 1000, "pic.png"};
}

[[nodiscard]] VerifyRun run_of(std::vector<Verdict> verdicts, bool replay = false) {
  return {.subject = "built-in",
          .profile = "exact",
          .replay = replay,
          .seed = 42,
          .verdicts = std::move(verdicts)};
}

TEST(Verdict, PassesWhereEveryLawHolds) {
  EXPECT_TRUE(passed(run_of({holding("COV"), holding("MAP")})));
  EXPECT_FALSE(passed(run_of({holding("COV"), violated("MAP")})));
  EXPECT_FALSE(passed(run_of({violated("MAP")}, true)));
}

TEST(Verdict, CountsALawWithoutASayAsAFailure) {
  EXPECT_EQ(outcome(holding("MAP", 0)), "judged nothing");
  EXPECT_FALSE(passed(run_of({holding("COV"), holding("MAP", 0)})));
  expect_contains(
      table_summary(run_of({holding("COV"), holding("MAP", 0)})),
      "1 of 2 laws hold, 1 judged nothing, which shows nothing and counts as a failure");
}

TEST(Verdict, OfAReplayNeedsOneLawWithASay) {
  EXPECT_TRUE(passed(run_of({holding("COV"), holding("MAP", 0)}, true)));
  EXPECT_FALSE(passed(run_of({holding("COV", 0), holding("MAP", 0)}, true)));
}

TEST(VerdictTable, HasARowForEachLaw) {
  EXPECT_EQ(table_header() + table_row(holding("COV")) + table_row(violated("MAP")),
            "law        verdict               cases  pixels judged       time\n"
            "COV        holds                    20            100     1.50 s\n"
            "MAP        VIOLATED                  7             55     0.00 s\n");
}

TEST(VerdictTable, CountsTheLaws) {
  EXPECT_EQ(table_summary(run_of({holding("COV"), violated("MAP")})),
            "1 of 2 laws hold, 1 violated.\n");
  EXPECT_EQ(table_summary(run_of({holding("COV"), holding("MAP", 0)}, true)),
            "1 of 2 laws hold, 1 judged nothing in this case.\n");
}

TEST(VerdictTable, SaysThatTheOracleIsMissing) {
  VerifyRun run = run_of({holding("COV")});
  run.oracle_missing = true;
  expect_contains(table_summary(run), "ORACLE is not in this build");
}

TEST(VerdictJson, TellsEverything) {
  const auto values =
      nlohmann::json::parse(verdict_json(run_of({holding("COV"), violated("MAP")})));
  EXPECT_EQ(values["subject"], "built-in");
  EXPECT_EQ(values["passed"], false);
  EXPECT_EQ(values["seed"], 42);
  ASSERT_EQ(values["laws"].size(), 2u);
  EXPECT_EQ(values["laws"][0], nlohmann::json::parse(R"({"law": "COV", "verdict": "holds",
      "cases": 20, "judged_px": 100, "time_ns": 1500000000})"));
  const auto& violation = values["laws"][1]["violation"];
  EXPECT_EQ(values["laws"][1]["verdict"], "violated");
  EXPECT_EQ(violation["what"], "it should have held");
  EXPECT_EQ(violation["pixel_px"], nlohmann::json::parse("[3, 4]"));
  EXPECT_EQ(violation["u_texel"], "7/2");
  EXPECT_EQ(violation["allowed"], "texel (3, 0)");
  EXPECT_EQ(violation["drawn"], "texel (4, 0)");
  EXPECT_EQ(violation["case"], spec::to_hex(spec::Case{}));
  EXPECT_EQ(violation["replay"], "selvage verify --law MAP --case " + spec::to_hex(spec::Case{}));
  EXPECT_EQ(violation["picture"], "pic.png");
}

TEST(VerdictJson, OfAReplayHasNoSeed) {
  const auto values = nlohmann::json::parse(verdict_json(run_of({holding("COV")}, true)));
  EXPECT_FALSE(values.contains("seed"));
}

}  // namespace
}  // namespace selvage::cli::test
