// `selvage verify` of libraries: what it prints, what it keeps, what it refuses.
#include <chrono>
#include <nlohmann/json.hpp>
#include <sstream>

#include "cli/picture_file.h"
#include "cli/verify_command.h"
#include "support.h"

namespace selvage::cli::test {
namespace {

[[nodiscard]] std::string library(const std::string& name) {
  return SELVAGE_SUBJECTS "/" + name + ".so";
}

class VerifySubject : public InDirectory {
 protected:
  VerifySubject() {
    options_.cases = "30";
    options_.seed = "5";
    options_.subject.call_limit = "20";
  }

  int run(const std::string& name) {
    out_.str("");
    err_.str("");
    options_.subject.library = library(name);
    return run_verify(options_, spec::built_in(), {out_, err_});
  }
  [[nodiscard]] std::string out() const { return out_.str(); }
  [[nodiscard]] std::string err() const { return err_.str(); }

  VerifyOptions options_;

 private:
  std::ostringstream out_, err_;
};

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
  EXPECT_EQ(out().find("not exported: selvage_prepare"), std::string::npos) << out();
  expect_contains(get("verdict.xml"), "<property name=\"not exported\" value=\"selvage_choose\"/>");
  options_.laws = {"SAME"};
  options_.json = true;
  EXPECT_EQ(run("chooses_right"), kExitFine) << out();
  const auto missing = nlohmann::json::parse(out())["not_exported"];
  ASSERT_EQ(missing.size(), 2u);
  EXPECT_EQ(missing[1]["function"], "selvage_prepare");
  EXPECT_EQ(missing[1]["law"], "SAME");
}

TEST_F(VerifySubject, ThatFailsToPrepareHasAPictureOfNothing) {
  options_.laws = {"SAME"};
  EXPECT_EQ(run("prepares_source"), kExitLawFailed);
  expect_contains(out(), "it wrote in the texture, at texel (0, 0) (SIGSEGV)");
  EXPECT_GT(read_picture("selvage-SAME.png").width_px, 3);
}

TEST_F(VerifySubject, ThatCrashesEndsInAVerdictAndAPicture) {
  options_.laws = {"MAP", "COV"};
  EXPECT_EQ(run("writes_after"), kExitLawFailed);
  expect_contains(out(), "0 of 2 laws hold, 2 violated.");
  expect_contains(out(), "drawn    it wrote just after the end of the target");
  expect_contains(out(), "replay: selvage verify --subject " + shell_word(library("writes_after")) +
                             " --call-limit 20 --law COV --case ");
  EXPECT_GT(read_picture("selvage-COV.png").width_px, 3);
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
  expect_contains(out(), violation["drawn"].get<std::string>());
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

TEST_F(VerifySubject, TellsWhatItDoesNotClaim) {
  EXPECT_EQ(run("claims_little"), kExitFine) << out();
  expect_contains(out(), "subject little 7, profile exact\n");
  expect_contains(out(), "not promised: CLIP: it does not clip\n");
  expect_contains(out(), "not promised: IDENTITY: it draws triangles alone");
  expect_contains(out(), "not promised: TOTAL: it does not name errors\n");
}

TEST_F(VerifySubject, IsToldOtherwiseOnTheCommandLine) {
  options_.subject.name = "mine";
  options_.subject.clip = true;
  options_.subject.formats = {"rgb565", "index8"};
  options_.subject.winding = "counter-clockwise";
  EXPECT_EQ(run("claims_little"), kExitFine) << out();
  expect_contains(out(), "subject mine, profile exact\n");
  expect_contains(out(), "\nCLIP ");
  expect_contains(out(), "not promised: FILTER: it does not draw RGBA8888");
  options_.laws = {"PART"};
  options_.profile = "dkit";
  EXPECT_EQ(run("right"), kExitLawFailed);
  expect_contains(out(),
                  " --call-limit 20 --name mine --winding counter-clockwise --formats "
                  "rgb565,index8 --clip --law PART --case ");
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
  for (const char* shard : {"0/2", "3/2", "1", "1/2/3", "a/b", "-1/2"}) {
    expect_contains(refused([&](VerifyOptions& o) { o.shard = shard; }),
                    "--shard: '" + std::string(shard) + "' is no shard");
  }
  expect_contains(refused([](VerifyOptions& o) { o.shard = "1/300"; }), "are too few for 300");
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

TEST_F(VerifySubject, TriesWhatIsKnownFirst) {
  options_.corpus = "known";
  options_.laws = {"COV"};
  EXPECT_EQ(run("draws_nothing"), kExitLawFailed);
  expect_contains(out(), "corpus 0 known cases\n");
  ASSERT_EQ(std::distance(std::filesystem::directory_iterator("known"), {}), 1);
  options_.seed = "77";
  options_.json = true;
  EXPECT_EQ(run("draws_nothing"), kExitLawFailed);
  const auto law = nlohmann::json::parse(out())["laws"][0];
  EXPECT_EQ(law["violation"]["found_by"], "corpus");
  EXPECT_EQ(law["cases"], 1);
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator("known"), {}), 1)
      << "it is known already";
  EXPECT_EQ(run("right"), kExitFine) << out();
}

// What one subject was found to do wrong is tried on the next, as that one's profile and claims
// take it, and what cannot be is told.
TEST_F(VerifySubject, SharesItsCorpusWithOthers) {
  options_.corpus = "known";
  options_.laws = {"COV", "IDENTITY"};
  options_.profile = "dkit";
  EXPECT_EQ(run("draws_nothing"), kExitLawFailed);
  ASSERT_EQ(std::distance(std::filesystem::directory_iterator("known"), {}), 2);
  options_.profile = "";
  options_.laws = {"COV"};
  EXPECT_EQ(run("aborts"), kExitLawFailed);
  expect_contains(out(), "corpus 2 known cases\n");
  expect_contains(out(), "known, not judged: IDENTITY: 1 cases: the law is not checked\n");
  options_.json = true;
  EXPECT_EQ(run("aborts"), kExitLawFailed);
  const auto aborted = nlohmann::json::parse(out());
  EXPECT_EQ(aborted["laws"][0]["violation"]["found_by"], "corpus");
  EXPECT_EQ(aborted["known_of_others"]["IDENTITY"], 1);
  options_.laws = {};
  EXPECT_EQ(run("claims_little"), kExitFine) << out();
  const auto little = nlohmann::json::parse(out());
  EXPECT_EQ(little["known_cases"], 2);
  EXPECT_EQ(little["known_of_others"]["IDENTITY"], 1) << "it does not promise it";
  EXPECT_EQ(little["laws"][0]["known"]["tried"], 1);
  EXPECT_TRUE(little["laws"][0]["known"]["not_judged"].empty())
      << "a triangle is within its claims";
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator("known"), {}), 2)
      << "nothing new was found";
}

TEST_F(VerifySubject, RefusesACorpusThatIsNone) {
  std::filesystem::create_directory("known");
  put("known/x.case", std::string("COV 12"));
  options_.corpus = "known";
  expect_contains(error_of([&] { run("right"); }), "'known/x.case' is no known violation");
  options_.corpus = "";
  for (const char* hunt : {"-1", "x", "1000000001"}) {
    options_.hunt = hunt;
    expect_contains(error_of([&] { run("right"); }),
                    "--hunt: '" + std::string(hunt) + "' is no number from 0 to");
  }
}

TEST_F(VerifySubject, IsHunted) {
  options_.laws = {"COV"};
  options_.hunt = "40";
  EXPECT_EQ(run("right"), kExitFine) << out();
  expect_contains(out(), "\nhunted: COV: 40 cases, the best 0.");
  options_.json = true;
  EXPECT_EQ(run("claims_little"), kExitFine) << out();
  const auto values = nlohmann::json::parse(out());
  EXPECT_EQ(values["hunted"], 40);
  EXPECT_EQ(values["laws"][0]["cases"], 70);
  EXPECT_EQ(values["laws"][0]["hunted"]["cases"], 40);
  EXPECT_GT(values["laws"][0]["hunted"]["best"]["closeness"], 0.0);
}

// Each law gets a round of cases at least, and all of them the same number of rounds or one more.
TEST_F(VerifySubject, FitsIntoATime) {
  options_.time = "0.05";
  options_.laws = {"COV", "MEM", "CLIP"};
  options_.json = true;
  EXPECT_EQ(run("right"), kExitFine) << out();
  const auto laws = nlohmann::json::parse(out())["laws"];
  constexpr int kRound = 20 + 12;  // at random, and a climb
  for (const auto& law : laws) {
    EXPECT_GE(law["cases"], 20);
    EXPECT_LE(laws[2]["cases"], law["cases"]);
    EXPECT_LE(law["cases"].get<int>() - laws[2]["cases"].get<int>(), kRound);
  }
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

// 19 laws, each of which would be shrunk and drawn.
TEST_F(VerifySubject, ThatHangsKeepsTheTime) {
  options_.subject.call_limit = "0.4";
  options_.time = "1";
  options_.json = true;
  const auto start = std::chrono::steady_clock::now();
  EXPECT_EQ(run("hangs"), kExitLawFailed);
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(5));
  const auto violation = nlohmann::json::parse(out())["laws"][0]["violation"];
  EXPECT_EQ(violation["smallest"], false);
  expect_contains(violation["notes"][0].get<std::string>(),
                  "this is not the smallest counterexample");
  EXPECT_GT(read_picture("selvage-COV.png").width_px, 3) << "of what was drawn until then";
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
