// `selvage verify` of libraries: what they claim, by themselves and on the command line.
#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "verify_subject.h"

namespace selvage::cli::test {
namespace {

using VerifyClaims = VerifySubject;

TEST_F(VerifyClaims, TellsWhatItDoesNotClaim) {
  EXPECT_EQ(run("claims_little"), kExitFine) << out();
  expect_contains(out(), "subject little 7, profile exact\n");
  expect_contains(out(), "not promised: CLIP: it does not clip\n");
  expect_contains(out(), "not promised: IDENTITY: it draws triangles alone");
  expect_contains(out(), "not promised: TOTAL: it does not name errors\n");
}

TEST_F(VerifyClaims, IsToldOtherwiseOnTheCommandLine) {
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

TEST_F(VerifyClaims, IsDrawnInPicturesUnlessNoneAreWanted) {
  const auto pictures = [] {
    return std::ranges::count_if(std::filesystem::directory_iterator("."), [](const auto& entry) {
      return entry.path().extension() == ".png";
    });
  };
  options_.laws = {"MAP"};
  options_.cases = "200";
  options_.draws_pictures = false;
  EXPECT_EQ(run("off_beyond"), kExitLawFailed);
  EXPECT_EQ(pictures(), 0);
  options_.draws_pictures = true;
  EXPECT_EQ(run("off_beyond"), kExitLawFailed);
  EXPECT_EQ(pictures(), 1);
}

TEST_F(VerifyClaims, IsHeldToTheAccuracyThatItClaims) {
  options_.laws = {"MAP", "CLIP", "SAME"};
  options_.cases = "1000";
  EXPECT_EQ(run("off_within"), kExitFine) << out();
  expect_contains(out(), "subject off_within.so, profile exact, within 1/256 texel\n");
  options_.junit = "verdict.xml";
  EXPECT_EQ(run("off_beyond"), kExitLawFailed) << out();
  expect_contains(out(), "in part: the coverage; texels are within its accuracy (MAP): CLIP\n");
  expect_contains(get("verdict.xml"), "; in part: each drawing within its accuracy</system-out>");
  expect_contains(out(), "1 of 3 laws hold, 2 violated.");
  expect_contains(out(),
                  "law MAP is broken: a texel lies within the claimed accuracy, 1/256 texel");
  expect_contains(get("verdict.xml"), "<property name=\"accuracy_fx16\" value=\"256\"/>");
}

TEST_F(VerifyClaims, IsToldAnotherAccuracyOnTheCommandLine) {
  options_.laws = {"MAP"};
  options_.cases = "1000";
  options_.json = true;
  const std::pair<const char*, int32_t> read[] = {
      {"0", 0}, {"1/128", 512}, {"0.0078125", 512}, {"1/65536", 1}, {"16384", 1 << 30}};
  for (const auto& [accuracy, fx16] : read) {
    options_.subject.accuracy = accuracy;
    EXPECT_EQ(run("off_beyond"), fx16 >= 512 ? kExitFine : kExitLawFailed) << accuracy;
    const auto verdict = nlohmann::json::parse(out());
    EXPECT_EQ(verdict["accuracy_fx16"], fx16);
    expect_contains(verdict["arguments"].get<std::string>(),
                    " --accuracy " + std::string(accuracy));
  }
  for (const char* none : {"-1", "x", "1/0", "1/-2", "1/2/3", "/", "0.00001", "16385", "nan"}) {
    options_.subject.accuracy = none;
    expect_contains(error_of([&] { run("right"); }),
                    "--accuracy: '" + std::string(none) + "' is none; texels from 1/65536");
  }
  options_.subject.accuracy = "1/4";
  options_.profile = "dkit";
  expect_contains(error_of([&] { run("right"); }), "an accuracy is claimed in profile exact alone");
}

// The left edge is 1/256 px right of the first centre.
TEST_F(VerifyClaims, IsHeldToTheCoverageThatItClaims) {
  const spec::Case beside{
      .vertices = {{129, 0, 0, 0, 1}, {4096, 0, 65536, 0, 1}, {129, 4096, 0, 65536, 1}}};
  options_.laws = {"COV"};
  options_.case_hex = spec::to_hex(beside);
  EXPECT_EQ(run("off_left"), kExitLawFailed);
  expect_contains(out(), "  off by   0.00391 px, the outline\n");
  options_.subject.coverage_accuracy = "1/257";
  EXPECT_EQ(run("off_left"), kExitLawFailed);
  options_.subject.coverage_accuracy = "1/256";
  options_.junit = "verdict.xml";
  EXPECT_EQ(run("off_left"), kExitFine) << out();
  expect_contains(out(), "subject off_left.so, profile exact, within 1/256 px of its outline\n");
  expect_contains(out(), "1.00 of bound");
  expect_contains(out(), "in part: within the accuracy of its coverage: COV\n");
  expect_contains(get("verdict.xml"), "<property name=\"coverage_accuracy_fx16\" value=\"256\"/>");
  options_.json = true;
  EXPECT_EQ(run("off_left"), kExitFine);
  const auto verdict = nlohmann::json::parse(out());
  EXPECT_EQ(verdict["coverage_accuracy_fx16"], 256);
  expect_contains(verdict["arguments"].get<std::string>(), " --coverage-accuracy 1/256");
  for (const char* none : {"-1", "1.5", "0.00001", "x"}) {
    options_.subject.coverage_accuracy = none;
    expect_contains(error_of([&] { run("right"); }), "--coverage-accuracy: '" + std::string(none) +
                                                         "' is none; pixels from 1/65536 to 1, as");
  }
}

TEST_F(VerifyClaims, IsToldHowFarItsVerticesMayLie) {
  const spec::Case far{
      .vertices = {{-512, 0, 0, 0, 1}, {4096, 0, 65536, 0, 1}, {0, 256, 0, 65536, 1}}};
  options_.laws = {"COV"};
  options_.case_hex = spec::to_hex(far);
  options_.subject.guard_band = "2";
  EXPECT_EQ(run("right"), kExitFine);
  options_.subject.guard_band = "1";
  EXPECT_EQ(run("right"), kExitLawFailed);
  expect_contains(out(), "vertices too far from the target for it");
  options_.subject.guard_band = "0";
  EXPECT_EQ(run("right"), kExitFine) << "anywhere";
  options_.subject.outside_vertices = false;
  expect_contains(error_of([&] { run("right"); }), "one or the other is right");
  options_.subject.guard_band.clear();
  EXPECT_EQ(run("right"), kExitLawFailed);
  options_.subject.outside_vertices = true;
  EXPECT_EQ(run("right"), kExitFine);
  options_.subject.guard_band = "-1";
  expect_contains(error_of([&] { run("right"); }), "--guard-band: '-1' is no number from 0 on");
}

TEST_F(VerifyClaims, IsToldItsStepsOnTheCommandLine) {
  const spec::Case between{
      .vertices = {{0, 0, 0, 0, 1}, {4096, 8, 65536, 0, 1}, {0, 4096, 0, 65536, 1}}};
  options_.laws = {"COV"};
  options_.case_hex = spec::to_hex(between);
  for (const char* step : {"1/32", "0.03125", "1/256"}) {
    options_.subject.position_step = step;
    EXPECT_EQ(run("right"), kExitFine) << step;
  }
  options_.subject.position_step = "1";
  EXPECT_EQ(run("right"), kExitLawFailed);
  expect_contains(out(), "vertices between the places that it takes");
  for (const char* none : {"0", "-1", "2", "1/3", "1/512", "x", ""}) {
    options_.subject.position_step = *none != 0 ? none : "1/";
    expect_contains(error_of([&] { run("right"); }), "is no step; 1, 1/2, 1/4 and so on to 1/256");
  }
  options_.subject.position_step.clear();
  options_.subject.coordinate_step = "3/4";
  expect_contains(error_of([&] { run("right"); }),
                  "--coordinate-step: '3/4' is no step; 1, 1/2, 1/4 and so on to 1/65536 are");
}

}  // namespace
}  // namespace selvage::cli::test
