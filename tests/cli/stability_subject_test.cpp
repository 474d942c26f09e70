// `selvage stability` of libraries.
#include <nlohmann/json.hpp>
#include <sstream>

#include "cli/stability_command.h"
#include "verify_subject.h"

namespace selvage::cli::test {
namespace {

class StabilityOfASubject : public InDirectory {
 protected:
  StabilityOfASubject() {
    options_.families = {"flat-topped"};
    options_.cases = "2";
    options_.seed = "5";
    options_.json = true;
    options_.arithmetics = {"fixed1616"};
    options_.subject.call_limit = "20";
  }
  int run_with(const std::string& name) {
    options_.subject.library = library(name);
    out_.str("");
    err_.str("");
    return run_stability(options_, spec::built_in(), {out_, err_});
  }
  [[nodiscard]] std::string out() const { return out_.str(); }
  [[nodiscard]] std::string err() const { return err_.str(); }
  [[nodiscard]] nlohmann::json json() const { return nlohmann::json::parse(out()); }
  // Of the library, behind that of the one arithmetic.
  [[nodiscard]] nlohmann::json cell() const { return json()["families"][0]["cells"][1]; }

  StabilityOptions options_;

 private:
  std::ostringstream out_, err_;
};

TEST_F(StabilityOfASubject, MeasuresItBesideTheArithmetics) {
  EXPECT_EQ(run_with("right"), kExitFine) << out();
  EXPECT_EQ(json()["subject"], "right.so");
  EXPECT_EQ(json()["families"][0]["cells"].size(), 2u);
  EXPECT_EQ(cell()["wrong_texels"], 0);
  EXPECT_GT(cell()["compared_px"], 100);
  EXPECT_EQ(cell()["missing_px"], 0);
  EXPECT_FALSE(cell().contains("not_claimed_cases"));
  EXPECT_EQ(run_with("draws_nothing"), kExitFine) << "a subject promises nothing here";
  EXPECT_GT(cell()["missing_px"], 100);
  const std::string again = cell()["worst"]["command"];
  expect_contains(again, "selvage stability --subject " + library("draws_nothing"));
  expect_contains(again, " --arithmetic subject --seed ");
}

TEST_F(StabilityOfASubject, HoldsItToTheAccuracyThatItClaims) {
  options_.families = {"long-spans"};
  options_.cases = "6";
  EXPECT_EQ(run_with("off_within"), kExitFine) << out();
  EXPECT_GT(cell()["part_of_bound"], 0.5);
  EXPECT_LE(cell()["part_of_bound"], 1.0);
  EXPECT_EQ(run_with("off_beyond"), kExitLawFailed) << out();
  EXPECT_GT(cell()["part_of_bound"], 1.0);
  options_.json = false;
  EXPECT_EQ(run_with("off_beyond"), kExitLawFailed);
  expect_contains(out(), "BROKEN: subject on long-spans: a texel is beyond the claimed accuracy; ");
  options_.subject.accuracy = "1/8";
  EXPECT_EQ(run_with("off_beyond"), kExitFine) << out();
  EXPECT_EQ(run_with("draws_nothing"), kExitLawFailed);
  expect_contains(out(), "BROKEN: subject on long-spans: a pixel is missing or too much; ");
}

TEST_F(StabilityOfASubject, HoldsItToTheCoverageThatItClaims) {
  options_.families = {"near-ties"};
  options_.cases = "6";
  EXPECT_EQ(run_with("off_left"), kExitFine) << "it promises nothing";
  EXPECT_GT(cell()["missing_px"].get<int>() + cell()["extra_px"].get<int>(), 0);
  EXPECT_LE(cell()["largest_outline_px"], 1.0 / 256);
  options_.subject.accuracy = "64";  // its texels move with the outline
  EXPECT_EQ(run_with("off_left"), kExitLawFailed);
  options_.subject.coverage_accuracy = "1/256";
  EXPECT_EQ(run_with("off_left"), kExitFine) << out();
  EXPECT_FALSE(cell().contains("own_coverage_px"));
  EXPECT_EQ(run_with("draws_nothing"), kExitLawFailed);
  EXPECT_GT(cell()["own_coverage_px"], 0);
  EXPECT_GT(cell()["largest_outline_px"], 1);
}

TEST_F(StabilityOfASubject, TellsOfOneThatCrashes) {
  options_.picture = "worst.png";
  EXPECT_EQ(run_with("crashes"), kExitLawFailed);
  expect_contains(cell()["memory_fault"].get<std::string>(), "it wrote through a null pointer");
  expect_contains(err(), "no picture: the subject wrote through a null pointer");
  options_.json = false;
  EXPECT_EQ(run_with("crashes"), kExitLawFailed);
  expect_contains(out(), "BROKEN: subject on flat-topped: it wrote through a null pointer");
}

// It would take its time in each scene.
TEST_F(StabilityOfASubject, AsksNoMoreOfOneThatHangs) {
  options_.families = {"flat-topped", "flat-bottomed"};
  options_.subject.call_limit = "0.2";
  EXPECT_EQ(run_with("hangs"), kExitLawFailed);
  EXPECT_EQ(cell()["hung"], true);
  EXPECT_LT(cell()["missing_px"], json()["families"][0]["covered_px"]) << "in one scene of two";
  EXPECT_EQ(json()["families"][1]["cells"].size(), 1u);
  options_.json = false;
  EXPECT_EQ(run_with("hangs"), kExitLawFailed);
  expect_contains(out(), "it hung: no answer in 0.2 s");  // or more, where other load is
  expect_contains(out(), "; no more was asked of it; again: ");
  EXPECT_EQ(out().find("not claimed"), std::string::npos) << out();
  options_.arithmetics = {"subject"};
  EXPECT_EQ(run_with("hangs"), kExitLawFailed) << "nobody is left to measure";
}

TEST_F(StabilityOfASubject, LeavesOutWhatItDoesNotClaim) {
  options_.subject.longest_side = "3";
  EXPECT_EQ(run_with("right"), kExitLawFailed) << "nothing was measured";
  expect_contains(err(), "the subject was measured on nothing");
  EXPECT_EQ(cell()["not_claimed_cases"], 2);
  EXPECT_EQ(cell()["compared_px"], 0);
  options_.json = false;
  EXPECT_EQ(run_with("right"), kExitLawFailed);
  expect_contains(out(), "\nsubject         not claimed       -");
  expect_contains(out(), "not claimed: subject on flat-topped: 2 of 2 scenes\n");
  options_.json = true;
  options_.subject.longest_side.clear();
  options_.subject.formats = {"rgb565"};
  options_.subject.winding = "counter-clockwise";
  options_.subject.addresses = {"wrap"};
  EXPECT_EQ(run_with("right"), kExitFine);
  EXPECT_FALSE(cell().contains("not_claimed_cases"));
  EXPECT_EQ(cell()["wrong_texels"], 0) << "the format tells all places";
}

}  // namespace
}  // namespace selvage::cli::test
