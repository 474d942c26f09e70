// `selvage verify` of libraries: what is known, hunted for, and found in a time.
#include <chrono>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "cli/picture_file.h"
#include "verify_subject.h"

namespace selvage::cli::test {
namespace {

TEST_F(VerifySubject, TriesWhatIsKnownFirst) {
  options_.corpus = "known";
  options_.laws = {"COV"};
  EXPECT_EQ(run("draws_nothing"), kExitLawFailed);
  expect_contains(out(), "corpus 0 known cases\n");
  expect_contains(err(), "selvage: made the directory 'known'\n");
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
  options_.corpus = "nowhere/known";
  expect_contains(error_of([&] { run("right"); }), "there is no directory 'nowhere'");
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
  EXPECT_FALSE(violation.contains("picture")) << "what was drawn until then was right";
}

}  // namespace
}  // namespace selvage::cli::test
