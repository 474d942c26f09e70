#include "cli/verdict.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "cli/console.h"
#include "cli/junit.h"
#include "cli/verdict_json.h"

#include "support.h"

namespace selvage::cli::test {
namespace {

[[nodiscard]] Verdict holding(const char* law, uint64_t judged_px = 100) {
  spec::LawVerdict found{.law = spec::find_law(law), .cases = 20, .judged_px = judged_px};
  return {.found = std::move(found), .time_ns = 1'500'000'000};
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
  spec::LawVerdict found{.law = spec::find_law(law), .cases = 7, .judged_px = 55};
  found.violation = violation;
  found.counterexample = spec::Case{};
  found.failed_case = 6;
  return {.found = std::move(found), .time_ns = 1000, .picture = "pic.png"};
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
  EXPECT_FALSE(passed(run_of({}))) << "a verdict about nothing";
}

// A crash says the same whichever law made the call: once in full, and how to see it again each
// time.
TEST(Verdict, TellsOfACallOnceThatEndsAlikeInSeveralLaws) {
  const auto crashed = [](const char* law, const std::string& drawn) {
    Verdict verdict = violated(law);
    spec::Violation& violation = *verdict.found.violation;
    violation.is_of_call = true;
    violation.x_px = violation.y_px = -1;
    violation.what = "a call ends";
    violation.drawn = drawn;
    return verdict;
  };
  const std::string text = explanations(
      run_of({crashed("COV", "it wrote at 0x10b78f, at (3, 4)"),
              crashed("MAP", "it wrote at 0x7cafe, at (7, 12)"), crashed("CLIP", "it never ended"),
              violated("SPLIT"), violated("SHIFT")}));
  const auto count = [&](std::string_view part) {
    int found = 0;
    for (size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) {
      ++found;
    }
    return found;
  };
  EXPECT_EQ(count("is broken: a call ends\n"), 2) << text;
  EXPECT_EQ(count("law MAP is broken as COV is: it wrote at 0x7cafe, at (7, 12)\n"), 1) << text;
  EXPECT_EQ(count("is broken: it should have held\n"), 2) << text;
  EXPECT_EQ(count("replay: selvage verify"), 5) << text;
}

TEST(Verdict, CountsALawWithoutASayAsAFailure) {
  EXPECT_EQ(outcome(holding("MAP", 0)), "judged nothing");
  EXPECT_FALSE(passed(run_of({holding("COV"), holding("MAP", 0)})));
  expect_contains(
      table_summary(run_of({holding("COV"), holding("MAP", 0)})),
      "1 of 2 laws hold, 1 judged nothing, which shows nothing and counts as a failure");
}

TEST(Verdict, CountsALawThatIsNotPromisedAsNoFailure) {
  Verdict in_vain = holding("DDA", 0);
  in_vain.not_promised = "MAP judges it";
  EXPECT_EQ(outcome(in_vain), "not promised");
  VerifyRun run = run_of({holding("COV"), in_vain});
  EXPECT_EQ(exit_code(run), kExitFine);
  note_not_promised(&run);
  note_not_promised(&run);
  EXPECT_EQ(table_summary(run),
            "1 of 2 laws hold, 1 not promised.\nnot promised: DDA: MAP judges it\n");
  expect_contains(junit_xml(run), "tests=\"2\" failures=\"0\" errors=\"0\" skipped=\"1\"");
  expect_contains(junit_xml(run), "<skipped message=\"not promised: MAP judges it\"/>");
  EXPECT_EQ(exit_code(run_of({in_vain})), kExitLawFailed) << "nothing was shown";
  EXPECT_EQ(exit_code(run_of({in_vain, holding("COV", 0)})), kExitLawFailed);
  in_vain.found.judged_px = 1;
  EXPECT_EQ(outcome(in_vain), "holds");
  EXPECT_TRUE(notes_on(in_vain).empty());
  Verdict broken = violated("MIRROR");
  broken.not_promised = "truncation has a direction";
  ASSERT_EQ(notes_on(broken).size(), 1u);
  EXPECT_EQ(notes_on(broken)[0],
            "the law was asked for, but is not promised: truncation has a direction");
}

TEST(Verdict, CountsALawWithoutTimeAsNeitherHeldNorFailed) {
  Verdict unjudged = holding("MAP", 0);
  unjudged.lacked_time = true;
  const VerifyRun run = run_of({holding("COV"), unjudged});
  EXPECT_EQ(outcome(unjudged), "not judged");
  EXPECT_FALSE(passed(run));
  EXPECT_EQ(exit_code(run), kExitNoTime);
  expect_contains(table_summary(run), "1 of 2 laws hold, 1 not judged: the time was over");
  expect_contains(junit_xml(run), "failures=\"0\" errors=\"0\" skipped=\"1\"");
  expect_contains(junit_xml(run), "<skipped message=\"not judged: the time was over\"/>");
  EXPECT_EQ(exit_code(run_of({unjudged, violated("COV")})), kExitLawFailed);
  EXPECT_EQ(exit_code(run_of({unjudged, holding("COV", 0)})), kExitLawFailed);
  EXPECT_EQ(exit_code(run_of({holding("COV")})), kExitFine);
}

// A shard that had no time is none that passed, whatever the others did.
TEST(Verdict, OfAShardCountsALawWithoutTime) {
  Verdict unjudged = holding("MAP", 0);
  unjudged.lacked_time = true;
  VerifyRun shard = run_of({holding("COV", 0), unjudged});
  shard.shard = {1, 2};
  EXPECT_FALSE(passed(shard));
  EXPECT_EQ(exit_code(shard), kExitNoTime);
  expect_contains(table_summary(shard), "1 judged nothing in this shard, 1 not judged: the time");
  EXPECT_EQ(read_verdict("shard.json", verdict_json(shard)).verdicts[1].lacked_time, true);
  shard.verdicts[1].lacked_time = false;
  EXPECT_EQ(exit_code(shard), kExitFine);
}

TEST(Verdict, OfAReplayNeedsOneLawWithASay) {
  EXPECT_TRUE(passed(run_of({holding("COV"), holding("MAP", 0)}, true)));
  EXPECT_FALSE(passed(run_of({holding("COV", 0), holding("MAP", 0)}, true)));
}

TEST(VerdictTable, HasARowForEachLaw) {
  EXPECT_EQ(table_header() + table_row(holding("COV")) + table_row(violated("MAP")),
            "law        verdict               cases  pixels judged  largest error       time\n"
            "COV        holds                    20            100        0 wrong     1.50 s\n"
            "MAP        VIOLATED                  7             55                    0.00 s\n");
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
  EXPECT_EQ(violation["sample"], "(3.5, 4.5) px, not in the polygon");
  EXPECT_EQ(violation["u_texel"], "7/2");
  EXPECT_EQ(violation["allowed"], "texel (3, 0)");
  EXPECT_EQ(violation["drawn"], "texel (4, 0)");
  EXPECT_EQ(violation["case"], spec::to_hex(spec::Case{}));
  EXPECT_EQ(violation["replay"], "selvage verify --law MAP --case " + spec::to_hex(spec::Case{}));
  EXPECT_EQ(violation["picture"], "pic.png");
  EXPECT_FALSE(violation.contains("found_case"));
}

TEST(VerdictJson, TellsTheDrawingInTheUnitsOfTheInterface) {
  Verdict verdict = violated("CLIP");
  spec::Case& shown = verdict.found.violation->shown;
  shown.format = SELVAGE_RGB565;
  shown.filter = SELVAGE_FILTER_NEAREST;
  shown.address = SELVAGE_ADDRESS_WRAP;
  shown.layout = spec::Layout::kTiled;
  shown.target_width_px = 7;
  shown.target_height_px = 5;
  shown.flip_texture = true;
  shown.has_clip = true;
  shown.clip = {1, 2, 3, 4};
  shown.vertices = {{256, -1, 65536, 3, 9}};
  spec::Case found = shown;
  found.choice = 5;
  verdict.found.found_case = found;
  const auto values = nlohmann::json::parse(verdict_json(run_of({verdict})));
  const auto& violation = values["laws"][0]["violation"];
  const auto& told = violation["shown"];
  EXPECT_EQ(told["format"], "rgb565");
  EXPECT_EQ(told["filter"], "nearest");
  EXPECT_EQ(told["address"], "wrap");
  EXPECT_EQ(told["layout"], "tiles");
  EXPECT_EQ(told["target_px"]["width"], 7);
  EXPECT_EQ(told["target_px"]["height"], 5);
  EXPECT_EQ(told["target_px"]["bottom_first"], false);
  EXPECT_EQ(told["texture_texel"]["bottom_first"], true);
  EXPECT_EQ(told["clip_px"], nlohmann::json::parse("[1, 2, 3, 4]"));
  EXPECT_EQ(told["vertices"], nlohmann::json::parse(R"([{"x_fx8": 256, "y_fx8": -1,
      "u_fx16": 65536, "v_fx16": 3, "q": 9}])"));
  EXPECT_EQ(violation["found_case"], spec::to_hex(found));
  EXPECT_EQ(violation["found_replay"], "selvage verify --law CLIP --case " + spec::to_hex(found));
}

// Everything that a run can have, there and back.
TEST(VerdictJson, IsReadAsItWasWritten) {
  VerifyRun run = run_of({holding("COV"), violated("MAP"), holding("CLIP", 0)});
  run.verdicts[0].found.margin = {0.5, 0.75};
  run.verdicts[0].found.not_claimed = {{"perspective", 3}};
  run.verdicts[0].found.hunted = {.cases = 12, .best = spec::Score{0.5, 0.25}};
  run.verdicts[0].known = {.tried = 2, .not_judged = {{"perspective", 1}}};
  run.verdicts[1].from_corpus = true;
  run.verdicts.push_back(violated("GAMUT"));
  run.verdicts.back().found.hunted = {.cases = 3, .best = {}, .found = true};
  run.verdicts.back().found.is_smallest = false;
  run.verdicts.back().found.replays = {.tried = 3, .failed = 1};
  run.hunted = 40;
  run.known_of_others = {{"TOTAL", 2}};
  run.not_promised = {{"SPLIT", "it cannot"}};
  run.verdicts.back().found.violation->scene = "and copies of it";
  run.verdicts.back().found.hung = true;
  run.verdicts.back().found.violation->off_by = {0.25, 1e-9};
  run.verdicts.back().found.violation->off_by_px = 0.0625;
  run.verdicts.back().found.violation->u.clear();
  run.verdicts.back().found.found_case = spec::Case{};
  run.verdicts.push_back(holding("DDA", 0));
  run.verdicts.back().not_promised = "MAP judges it";
  run.not_promised.push_back({"DDA", "MAP judges it"});
  run.not_exported = {{"selvage_subject", ""}, {"selvage_choose", "TOLERANCE"}};
  run.arguments = "--subject './my mapper.so'";
  run.cases = 20;
  run.known_cases = 2;
  run.shard = {2, 3};
  const std::string json = verdict_json(run);
  EXPECT_EQ(verdict_json(read_verdict("run.json", json)), json);
  expect_contains(json, "selvage verify --subject './my mapper.so' --law MAP --case ");
}

TEST(VerdictTable, TellsWhatWasHuntedAndWhatIsKnown) {
  VerifyRun run = run_of({holding("MAP"), violated("COV"), holding("CLIP")});
  run.verdicts[0].found.hunted = {.cases = 12, .best = spec::Score{0.5, 0.25}};
  run.verdicts[1].found.hunted = {.cases = 3, .best = {}, .found = true};
  run.verdicts[2].found.hunted = {.cases = 12, .best = spec::Score{0, 0.25}};
  run.verdicts[2].known = {.tried = 2, .not_judged = {{"perspective", 1}}};
  run.known_of_others = {{"TOTAL", 2}};
  expect_contains(table_summary(run),
                  "hunted: MAP: 12 cases, the best 0.50 of bound\n"
                  "hunted: COV: 3 cases, the last a violation\n"
                  "hunted: CLIP: 12 cases, the best 0.25 of the closeness there can be\n"
                  "known, not judged: CLIP: 1 cases: perspective\n"
                  "known, not judged: TOTAL: 2 cases: the law is not checked\n");
  EXPECT_EQ(found_by(run.verdicts[0]), "random");
  EXPECT_EQ(found_by(run.verdicts[1]), "hunt");
  run.verdicts[1].from_corpus = true;
  EXPECT_EQ(found_by(run.verdicts[1]), "corpus");
}

[[nodiscard]] std::string verdict_error(const std::string& text) {
  return error_of([&] { (void)read_verdict("a.json", text); });
}

TEST(VerdictJson, RefusesWhatItHasNotWritten) {
  const std::string needed = "what 'selvage verify --json' prints is needed";
  EXPECT_EQ(verdict_error(""), "a.json: the file is empty; " + needed);
  EXPECT_EQ(verdict_error("{}"), "a.json:1: 'selvage' is missing; " + needed);
  EXPECT_EQ(verdict_error("\n[]"), "a.json:2: 'selvage' is missing; " + needed);
  const std::string cut_off = verdict_error("{\n\"selvage\": \"0.1");
  expect_contains(cut_off, "a.json:2: not JSON: ");
  expect_contains(cut_off, "; " + needed);
  EXPECT_EQ(cut_off.find("json.exception"), std::string::npos) << cut_off;
  EXPECT_EQ(verdict_error("{\n\"selvage\": 3}"), "a.json:2: selvage: a text is needed, not 3");
  expect_contains(verdict_error(R"({"selvage": "0.0.0"})"),
                  "a.json:1: selvage: it is of version 0.0.0, this program of ");
}

TEST(VerdictJson, TellsWhereItIsDamaged) {
  const std::string good = verdict_json(run_of({holding("COV"), holding("MAP")}));
  const auto error_with = [&](const std::string& was, const std::string& is) {
    std::string text = good;
    text.replace(text.rfind(was), was.size(), is);
    return verdict_error(text);
  };
  const auto line = std::to_string(
      std::count(good.begin(), good.begin() + static_cast<ptrdiff_t>(good.rfind("\"MAP\"")), '\n') +
      1);
  expect_contains(error_with("\"MAP\"", "\"PAM\""),
                  "a.json:" + line + ": laws: law 2: law: this program knows no law 'PAM'");
  expect_contains(error_with("\"judged_px\"", "\"judged\""),
                  ": laws: law 2: 'judged_px' is missing");
}

TEST(Verdict, OfAShardLeavesToOthersWhatItDidNotJudge) {
  VerifyRun run = run_of({holding("COV"), holding("MAP", 0)});
  run.shard = {1, 2};
  EXPECT_TRUE(passed(run));
  run.verdicts.push_back(violated("CLIP"));
  EXPECT_FALSE(passed(run));
}

TEST(VerdictTable, TellsHowNearABoundIs) {
  Verdict verdict = holding("MAP");
  EXPECT_EQ(margin_text(verdict), "0 wrong");
  verdict.found.margin = {0.25, 0.5};
  EXPECT_EQ(margin_text(verdict), "0.50 of bound");
  EXPECT_EQ(margin_text(violated("MAP")), "");
}

TEST(VerdictTable, CountsWhatIsNotClaimed) {
  VerifyRun run = run_of({holding("COV")});
  run.verdicts[0].found.not_claimed = {{"perspective", 3}};
  run.not_promised = {{"CLIP", "it does not clip"}};
  expect_contains(table_summary(run), "not claimed: perspective: COV in 3 of 20 cases\n");
  expect_contains(table_summary(run), "not promised: CLIP: it does not clip\n");
}

TEST(Junit, HasATestForEachLaw) {
  VerifyRun run = run_of({holding("COV"), violated("MAP"), holding("CLIP", 0)});
  run.not_promised = {{"SPLIT", "both ends & more"}};
  run.verdicts[1].found.violation->what = "a < b\x01 \"c\"";
  const std::string xml = junit_xml(run);
  expect_contains(xml, "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n");
  expect_contains(xml, "tests=\"4\" failures=\"2\" errors=\"0\" skipped=\"1\" time=\"3.000\"");
  expect_contains(xml, "<property name=\"seed\" value=\"42\"/>");
  expect_contains(xml, "<testcase name=\"COV\" classname=\"built-in\" time=\"1.500\">");
  expect_contains(xml,
                  "<failure message=\"a &lt; b\xEF\xBF\xBD &quot;c&quot;\" type=\"violated\">");
  expect_contains(xml, "\nreplay: selvage verify --law MAP --case ");
  expect_contains(xml, "type=\"judged nothing\"");
  expect_contains(xml, "<skipped message=\"not promised: both ends &amp; more\"/>");
  EXPECT_EQ(xml.find('\x01'), std::string::npos);
}

TEST(Junit, IsXmlWhateverItTells) {
  VerifyRun run = run_of({violated("MAP")});
  run.subject = "\xC3\xA4\xFF\xC3 \xEF\xBF\xBE\x1B[31m";
  const std::string bad = "\xEF\xBF\xBD";
  const std::string shown = "\xC3\xA4" + bad + bad + " " + bad + bad + "[31m";
  expect_contains(junit_xml(run), "classname=\"" + shown + "\"");
  EXPECT_EQ(read_verdict("run.json", verdict_json(run)).subject, shown);
}

TEST(VerdictJson, OfAReplayHasNoSeed) {
  const auto values = nlohmann::json::parse(verdict_json(run_of({holding("COV")}, true)));
  EXPECT_FALSE(values.contains("seed"));
}

}  // namespace
}  // namespace selvage::cli::test
