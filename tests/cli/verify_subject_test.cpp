// `selvage verify` of libraries: what it prints, what it keeps, what it refuses.
#include <nlohmann/json.hpp>
#include <sstream>

#include "cli/picture_file.h"
#include "verify_subject.h"

namespace selvage::cli::test {
namespace {

TEST_F(VerifySubject, OfARightOneHolds) {
  EXPECT_EQ(run("right"), kExitFine) << out();
  expect_contains(out(), "subject right.so, profile exact\nseed 5\n");
  EXPECT_EQ(out().find("not claimed"), std::string::npos) << out();
  EXPECT_EQ(out().find("not promised"), std::string::npos) << out();
  EXPECT_EQ(err(), "");
}

// What a library does not export is told, and is no failure.
TEST_F(VerifySubject, TellsWhatItDoesNotExport) {
  options_.laws = {"SAME", "TOLERANCE"};
  options_.junit = "verdict.xml";
  EXPECT_EQ(run("prepares_right"), kExitFine) << out();
  expect_contains(out(), "not exported: selvage_draw_many: SAME says nothing of it\n");
  expect_contains(out(), "not exported: selvage_choose: TOLERANCE says nothing of it\n");
  expect_contains(out(),
                  "not exported: selvage_subject: what it claims is told by the command line, "
                  "or is all of its profile\n");
  EXPECT_EQ(out().find("not exported: selvage_prepare"), std::string::npos) << out();
  expect_contains(get("verdict.xml"),
                  "<property name=\"not exported\" value=\"selvage_subject, selvage_draw_many, "
                  "selvage_choose\"/>");
  options_.laws = {"SAME"};
  options_.json = true;
  EXPECT_EQ(run("chooses_right"), kExitFine) << out();
  const auto missing = nlohmann::json::parse(out())["not_exported"];
  ASSERT_EQ(missing.size(), 3u);
  EXPECT_FALSE(missing[0].contains("law"));
  EXPECT_EQ(missing[2]["function"], "selvage_prepare");
  EXPECT_EQ(missing[2]["law"], "SAME");
  EXPECT_EQ(run("clockwise"), kExitFine) << out();
  EXPECT_EQ(nlohmann::json::parse(out())["not_exported"][0]["function"], "selvage_draw_many");
}

// The polygon that it fails at has shrunk to nothing: there is no picture of that.
TEST_F(VerifySubject, ThatFailsToPrepareHasNoPicture) {
  options_.laws = {"SAME"};
  EXPECT_EQ(run("prepares_source"), kExitLawFailed);
  expect_contains(out(), "it wrote in the texture, at texel (0, 0) (SIGSEGV)");
  EXPECT_EQ(out().find("picture:"), std::string::npos);
}

TEST_F(VerifySubject, ThatCrashesEndsInAVerdict) {
  options_.laws = {"MAP", "COV"};
  EXPECT_EQ(run("crashes"), kExitLawFailed);
  expect_contains(out(), "0 of 2 laws hold, 2 violated.");
  expect_contains(out(), "law COV is broken as MAP is: it wrote through a null pointer");
  EXPECT_EQ(out().find("picture:"), std::string::npos);
}

// All is right in the picture: there is none.
TEST_F(VerifySubject, ThatWritesBesideItsTargetEndsInAVerdict) {
  options_.laws = {"MAP", "COV"};
  EXPECT_EQ(run("writes_after"), kExitLawFailed);
  expect_contains(out(), "0 of 2 laws hold, 2 violated.");
  expect_contains(out(), "drawn    it wrote just after the end of the target");
  expect_contains(out(), "replay: selvage verify --subject " + shell_word(library("writes_after")) +
                             " --call-limit 20 --law COV --case ");
  EXPECT_EQ(out().find("picture:"), std::string::npos);
}

TEST_F(VerifySubject, ThatRefusesIsToldBySayingWhatItReturned) {
  const std::string told =
      "it returned 3 (SELVAGE_ERROR_TARGET_SIZE) for a valid polygon; 0 (SELVAGE_OK) is right";
  options_.laws = {"COV", "PART"};
  options_.junit = "verdict.xml";
  for (const char* name : {"refuses_always", "refuses_at_times"}) {
    options_.json = false;
    EXPECT_EQ(run(name), kExitLawFailed) << name;
    expect_contains(out(), "0 of 2 laws hold, 2 violated.");
    expect_contains(out(), "drawn    " + told);
    expect_contains(get("verdict.xml"), told);
    options_.json = true;
    EXPECT_EQ(run(name), kExitLawFailed) << name;
    EXPECT_EQ(nlohmann::json::parse(out())["laws"][0]["violation"]["drawn"], told);
  }
}

TEST_F(VerifySubject, ReplaysACrash) {
  options_.laws = {"MEM"};
  options_.json = true;
  EXPECT_EQ(run("writes_before"), kExitLawFailed);
  const auto violation = nlohmann::json::parse(out())["laws"][0]["violation"];
  options_.json = false;
  options_.cases = "200";
  options_.seed = "";
  options_.case_hex = violation["case"];
  EXPECT_EQ(run("writes_before"), kExitLawFailed);
  const auto drawn = violation["drawn"].get<std::string>();
  expect_contains(out(), drawn.substr(0, drawn.find(", with ")));  // memory of a sanitizer's
  EXPECT_EQ(run("right"), kExitFine);
}

TEST_F(VerifySubject, KeepsItsOutputApart) {
  options_.laws = {"COV"};
  options_.json = true;
  EXPECT_EQ(run("prints"), kExitFine);
  EXPECT_TRUE(nlohmann::json::accept(out()));
  expect_contains(err(), "selvage: the subject has printed ");
  options_.subject.output = "printed";
  EXPECT_EQ(run("prints"), kExitFine);
  EXPECT_EQ(err(), "");
  expect_contains(get("printed"), "drew 3 vertices\n");
}

TEST_F(VerifySubject, RefusesWrongUse) {
  const auto refused = [&](auto change, const std::string& name = "right") {
    options_ = {};
    change(options_);
    return error_of([&] { run(name); });
  };
  expect_contains(refused([](VerifyOptions&) {}, "none"), "there is no such file");
  expect_contains(refused([](VerifyOptions&) {}, "no_draw"), "it exports no selvage_draw");
  for (const char* limit : {"0", "-1", "soon", "4000"}) {
    expect_contains(refused([&](VerifyOptions& o) { o.subject.call_limit = limit; }),
                    "--call-limit: '" + std::string(limit) + "' is no time");
  }
  expect_contains(refused([](VerifyOptions& o) { o.subject.filters = {"bilinear"}; }),
                  "--filters: nearest must be among them");
  expect_contains(refused([](VerifyOptions& o) { o.subject.formats = {"rgb"}; }),
                  "--formats: 'rgb' is no format");
  expect_contains(refused([](VerifyOptions& o) { o.subject.addresses = {"mirror"}; }),
                  "--addresses: 'mirror' is no address mode");
  expect_contains(refused([](VerifyOptions& o) { o.subject.winding = "left"; }),
                  "--winding: 'left' is none");
  expect_contains(refused([](VerifyOptions& o) { o.subject.most_vertices = "2"; }),
                  "--most-vertices: '2' is no number from 3 on");
  expect_contains(refused([](VerifyOptions& o) { o.subject.longest_side = "-1"; }),
                  "--longest-side: '-1' is no number from 0 on");
  for (const char* shard : {"0/2", "3/2", "1", "1/2/3", "a/b", "-1/2"}) {
    expect_contains(refused([&](VerifyOptions& o) { o.shard = shard; }),
                    "--shard: '" + std::string(shard) + "' is no shard");
  }
  expect_contains(refused([](VerifyOptions& o) { o.shard = "1/3000"; }), "are too few for 3000");
  for (const char* time : {"0", "-1", "long"}) {
    expect_contains(refused([&](VerifyOptions& o) { o.time = time; }), "--time: '");
  }
  options_ = {};
  options_.subject.call_limit = "1";
  std::ostringstream out;
  expect_contains(error_of([&] {
                    (void)run_verify(options_, spec::built_in(), {out, out});
                  }),
                  "are about a --subject, and none is given");
}

[[nodiscard]] bool has_red(const Raster& picture) {
  for (int32_t y = 0; y < picture.height_px; ++y) {
    for (int32_t x = 0; x < picture.width_px; ++x) {
      if (picture.at(x, y) == Colour{255, 0, 0}) return true;
    }
  }
  return false;
}

// By itself no case of its fails, so neither a replay nor a new drawing shows what was wrong.
TEST_F(VerifySubject, ThatFailsAfterManyCallsIsToldAndDrawnAsItFailed) {
  const std::string note =
      "it depends on earlier calls or on chance: tried again by itself it failed 0 of 3 times";
  options_.laws = {"COV"};
  options_.junit = "verdict.xml";
  EXPECT_EQ(run("tires"), kExitLawFailed);
  expect_contains(out(), "\nnote: " + note);
  expect_contains(get("verdict.xml"), "note: " + note);
  EXPECT_TRUE(has_red(read_picture("selvage-COV.png")));
  options_.json = true;
  EXPECT_EQ(run("tires"), kExitLawFailed);
  const auto violation = nlohmann::json::parse(out())["laws"][0]["violation"];
  EXPECT_EQ(violation["replays"]["tried"], 3);
  EXPECT_EQ(violation["replays"]["failed"], 0);
  expect_contains(violation["notes"][0].get<std::string>(), note);
  EXPECT_EQ(run("draws_nothing"), kExitLawFailed);
  EXPECT_FALSE(nlohmann::json::parse(out())["laws"][0]["violation"].contains("notes"));
}

TEST_F(VerifySubject, IsToldByTheCaseThatWasFoundIfAsked) {
  options_.laws = {"COV"};
  options_.json = true;
  EXPECT_EQ(run("draws_nothing"), kExitLawFailed);
  const auto shrunk = nlohmann::json::parse(out())["laws"][0]["violation"];
  EXPECT_NE(shrunk["case"], shrunk["found_case"]);
  EXPECT_EQ(shrunk["smallest"], true);
  options_.shrinks = false;
  EXPECT_EQ(run("draws_nothing"), kExitLawFailed);
  const auto whole = nlohmann::json::parse(out())["laws"][0]["violation"];
  EXPECT_EQ(whole["case"], shrunk["found_case"]);
  EXPECT_EQ(whole["replay"], shrunk["found_replay"]);
  EXPECT_EQ(whole["replays"]["failed"], 3);
  EXPECT_EQ(whole["notes"][0], "it was not shrunk: this is the counterexample as it was found");
}

TEST_F(VerifySubject, WithALawThatItDoesNotPromiseIsToldWhy) {
  options_.laws = {"COV", "CLIP"};
  options_.subject.clip = false;
  EXPECT_EQ(run("right"), kExitFine) << out();
  expect_contains(out(), "1 of 2 laws hold, 1 not promised.\n");
  expect_contains(out(), "not promised: CLIP: it does not clip\n");
  options_.laws = {"CLIP"};
  EXPECT_EQ(run("right"), kExitLawFailed) << out();
}

TEST_F(VerifySubject, WithNoLongestSideTakesAny) {
  options_.laws = {"COV"};
  options_.subject.longest_side = options_.subject.longest_texture_side = "0";
  EXPECT_EQ(run("right"), kExitFine) << out();
  expect_contains(out(), "1 of 1 laws hold.\n");
}

// One law's counterexample is shrunk; the others would be of the same call, and take its time.
TEST_F(VerifySubject, ThatHangsIsShrunkOnce) {
  options_.laws = {"COV", "MEM"};
  options_.subject.call_limit = "0.2";
  options_.json = true;
  EXPECT_EQ(run("hangs"), kExitLawFailed);
  const auto laws = nlohmann::json::parse(out())["laws"];
  EXPECT_NE(laws[0]["violation"]["case"], laws[0]["violation"]["found_case"]);
  EXPECT_EQ(laws[1]["violation"]["case"], laws[1]["violation"]["found_case"]);
  options_.time = "20";
  EXPECT_EQ(run("hangs"), kExitLawFailed);
  const auto timed = nlohmann::json::parse(out())["laws"];
  EXPECT_NE(timed[0]["violation"]["case"], timed[0]["violation"]["found_case"]);
  EXPECT_EQ(timed[1]["violation"]["case"], timed[1]["violation"]["found_case"]);
}

TEST_F(VerifySubject, WritesJUnit) {
  options_.junit = "verdict.xml";
  options_.laws = {"COV", "MAP"};
  EXPECT_EQ(run("aborts"), kExitLawFailed);
  expect_contains(get("verdict.xml"), "it aborted (SIGABRT)");
  expect_contains(get("verdict.xml"), "<property name=\"seed\" value=\"5\"/>");
}

TEST(ShellWord, IsQuotedWhereItMustBe) {
  EXPECT_EQ(shell_word("./a-b_c.so"), "./a-b_c.so");
  EXPECT_EQ(shell_word("my mapper.so"), "'my mapper.so'");
  EXPECT_EQ(shell_word("it's"), "'it'\\''s'");
  EXPECT_EQ(shell_word("\xC3\xA4 a.so"), "'\xC3\xA4 a.so'");
  EXPECT_EQ(shell_word("it's \\ \x1B[31m\xFF"), R"($'it\047s \134 \033[31m\377')");
}

}  // namespace
}  // namespace selvage::cli::test
